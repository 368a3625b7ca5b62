// Several fine components while cracks grow: history moves from one to another, and the answers are those of one.
#include "coupling/ranks/fine_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "common/enrichment/part_of_mesh.hpp"
#include "common/error.hpp"
#include "common/index.hpp"
#include "coupling/ranks/zone_partition.hpp"
#include "tests/support/fine_team.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/whole_tangent.hpp"

namespace stria::test {
namespace {

class GrowingFineRanks : public FineRanks {
protected:
    using FineRanks::FineRanks;

    void turn_to(const EnrichedMesh& mesh) {
        patch = plate_patch(mesh);
        one.set_patch(patch);
        team.together->set_patch(patch);
    }

    /// Moves the boundary and commits; the last iterations stand still. Returns what one rank says.
    coupling::StepReport commit_the_same(const Eigen::VectorXd& u) {
        for (int iteration = 0; iteration < 12; ++iteration) {
            const Eigen::VectorXd there = u * (1.0 - 0.1 * std::max(0, 3 - iteration));
            const auto a = answer(one, iteration, there), b = answer(*team.together, iteration, there);
            EXPECT_LT(difference(b.force, a.force), 1e-9);
            EXPECT_LT(difference(whole(b.tangent), whole(a.tangent)), 1e-9);
            EXPECT_EQ(b.digest.yielding_points, a.digest.yielding_points);
        }
        const coupling::StepReport a = one.commit({}), b = team.together->commit({});
        EXPECT_NEAR(b.dissipation, a.dissipation, 1e-9 * a.dissipation);
        EXPECT_NEAR(b.energy.released, a.energy.released, 1e-9 * a.dissipation);
        EXPECT_NEAR(b.energy.stored, a.energy.stored, 1e-9 * a.energy.stored);
        for (std::size_t t = 0; t < a.tips.size(); ++t) EXPECT_NEAR(b.tips[t].CTOD, a.tips[t].CTOD, 1e-9);
        EXPECT_EQ(b.faces.size(), a.faces.size());
        EXPECT_EQ(b.points, a.points);
        EXPECT_LT(difference(team.together->state().displacement, one.state().displacement), 1e-9);
        return a;
    }
};

/// Twice before equilibrium is found again: what the first advance has opened is released with the second. Where the
/// crack turns history has to move.
TEST_P(GrowingFineRanks, AnswerAsOne) {
    const auto crack_to = [&](const std::vector<Vec2>& way) { turn_to(plate_mesh(11, 9, plate_case(way))); };
    crack_to({{0.0, 4.4}, {2.6, 4.4}});
    const Eigen::VectorXd u = boundary(4e-3, 1);
    EXPECT_EQ(commit_the_same(u).energy.released, 0.0);
    for (const double tip : {4.6, 6.6}) {
        crack_to({{0.0, 4.4}, {tip - 1.0, 4.4}});
        crack_to({{0.0, 4.4}, {tip, 4.4}});
        EXPECT_GT(std::abs(commit_the_same(u).energy.released), 0.0);
    }
    crack_to({{0.0, 4.4}, {6.6, 4.4}, {8.6, 7.4}});
    EXPECT_GT(std::abs(commit_the_same(u).energy.released), 0.0);
    EXPECT_EQ(team.together->history_moves() > 0, GetParam() > 1);
}

/// Predictors start from the same increments behind a growth, whether history has moved or not.
TEST_P(GrowingFineRanks, KnowTheIncrementsOfOne) {
    const auto crack_to = [&](const std::vector<Vec2>& way) { turn_to(plate_mesh(11, 9, plate_case(way), 0)); };
    crack_to({{0.0, 4.4}, {4.6, 4.4}});
    for (const double size : {2e-3, 4e-3}) (void)commit_the_same(boundary(size, 1));
    for (const std::vector<Vec2>& way :
         {std::vector<Vec2>{{0.0, 4.4}, {5.6, 4.4}}, {{0.0, 4.4}, {5.6, 4.4}, {6.6, 5.4}}}) {
        crack_to(way);
        const Eigen::MatrixXd increments = one.increments(), of_ranks = team.together->increments();
        ASSERT_EQ(increments.cols(), 2);
        ASSERT_EQ(of_ranks.cols(), 2);
        EXPECT_LT(difference(of_ranks, increments), 1e-9);
        for (int k = 0; k < 2; ++k) EXPECT_GT(increments.col(k).norm(), 0.0);
    }
}

/// Also where elements have changed their rank since.
TEST_P(GrowingFineRanks, GiveTheStateThatWasKept) {
    const auto crack_to = [&](const std::vector<Vec2>& way) { turn_to(plate_mesh(11, 9, plate_case(way))); };
    crack_to({{0.0, 4.4}, {6.6, 4.4}});
    (void)commit_the_same(boundary(4e-3, 1));
    team.together->keep();
    const coupling::ZoneSnapshot then = team.together->snapshot();
    crack_to({{0.0, 4.4}, {6.6, 4.4}, {8.6, 7.4}});
    const coupling::ZoneSnapshot kept = team.together->kept();
    EXPECT_EQ(kept.element, then.element);
    EXPECT_EQ(kept.rank, then.rank);
    EXPECT_EQ(kept.flow, then.flow);
    EXPECT_EQ(kept.history, then.history);
    EXPECT_EQ(kept.displacement, then.displacement);
}

/// Where most of the flow is with one rank, here in a corner, it gives elements away with the next patch.
TEST_P(GrowingFineRanks, ShareTheFlow) {
    turn_to(plate_mesh(11, 9, plate_case({{0.0, 4.4}, {2.6, 4.4}})));
    Eigen::VectorXd u = boundary(8e-3, 1);
    for (Eigen::Index k = 0; k < u.size(); ++k) {
        const auto owner = std::ranges::upper_bound(patch.mesh.first_unknown, patch.boundary[at(k)]);
        const auto node = owner - patch.mesh.first_unknown.begin() - 1;
        const Vec2 from_corner = patch.mesh.nodes[at(node)] - Vec2(11.0, 0.0);
        if (from_corner.norm() > 4.5) u[k] = 0.0;
    }
    for (const double sign : {1.0, -1.0, 1.0, -1.0, 1.0, -1.0}) (void)commit_the_same(sign * u);
    const auto cost = [&] {
        const coupling::ZoneSnapshot now = team.together->snapshot();
        return coupling::cost_of_sharing(patch.mesh, {now.rank.begin(), now.rank.end()}, now.flow);
    };
    const double before = cost();
    turn_to(patch.mesh);
    EXPECT_EQ(team.together->history_moves() > 0, GetParam() > 1);
    EXPECT_TRUE(cost() < 0.85 * before || GetParam() == 1);
    (void)commit_the_same(u);
}

/// A run that goes on thinks of another sharing where the undisturbed one does: not before the cost is another one.
TEST_P(GrowingFineRanks, ThinkOfAnotherSharingWhenTheUndisturbedOnesDo) {
    turn_to(plate_mesh(11, 9, plate_case({{0.0, 4.4}, {2.6, 4.4}})));
    (void)commit_the_same(boundary(8e-3, 1));
    turn_to(patch.mesh);
    const coupling::ZoneSnapshot then = team.together->snapshot();
    EXPECT_GT(then.weighed_cost, 0.0);
    Team resumed(input, GetParam());
    resumed.together->restore(patch, then);
    EXPECT_EQ(resumed.together->snapshot().weighed_cost, then.weighed_cost);
    team.together->keep();
    EXPECT_EQ(team.together->kept().weighed_cost, then.weighed_cost);
}

class TwoCracksOnFineRanks : public GrowingFineRanks {
protected:
    TwoCracksOnFineRanks() : GrowingFineRanks(two_alike()) {}

private:
    static Case two_alike() {
        Case input = one_crack();
        input.cracks.push_back(input.cracks[0]);
        return input;
    }
};

/// Each has a rank of its own until their tips are near each other.
TEST_P(TwoCracksOnFineRanks, ComeTogether) {
    const auto cracks_to = [&](double left, double right) {
        turn_to(with_hanging_node(plate_mesh(11, 9, two_cracks(left, right, 11.0)), {6.0, 4.0}));
    };
    const auto with_multipliers = [&] {
        return std::ranges::count_if(team.together->reports(), [](const auto& rank) { return rank.multipliers > 0; });
    };
    cracks_to(3.6, 8.4);
    const Eigen::VectorXd u = boundary(4e-3, 1);
    (void)commit_the_same(u);
    EXPECT_EQ(with_multipliers(), std::min(GetParam(), 2));
    cracks_to(6.6, 5.4);
    (void)commit_the_same(u);
    EXPECT_EQ(with_multipliers(), 1);
}

INSTANTIATE_TEST_SUITE_P(Number, GrowingFineRanks, testing::Values(1, 2, 3, 5));
INSTANTIATE_TEST_SUITE_P(Number, TwoCracksOnFineRanks, testing::Values(1, 2, 3, 5));

}  // namespace
}  // namespace stria::test
