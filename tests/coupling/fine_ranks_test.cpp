// Several fine components that look like one: answers, state, failures.
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

TEST_P(FineRanks, AnswerAsOne) {
    patch.unit_load = random_vector(patch.mesh.unknowns, 100.0, 3);
    patch.opening_at = {0.7};
    for (const int unknown : patch.boundary) patch.unit_load[unknown] = 0.0;
    one.set_patch(patch);
    team.together->set_patch(patch);
    const Eigen::VectorXd start = boundary(2e-3, 1), far = boundary(4e-3, 2);
    double work = 0.0;  // largest along a correction, N
    std::vector<double> opening;
    for (int increment = 0; increment < 3; ++increment) {
        // The last ones stand still: a state that is committed far from equilibrium may have a gap that is zero by
        // rounding alone.
        for (int iteration = 0; iteration < 12; ++iteration) {
            const Eigen::VectorXd u = start + (increment + 0.3 * std::min(iteration, 3)) * far;
            const auto a = answer(one, iteration, u, {0.7, 1}), b = answer(*team.together, iteration, u, {0.7, 1});
            EXPECT_LT(difference(b.force, a.force), 1e-9);
            EXPECT_LT(difference(whole(b.tangent), whole(a.tangent)), 1e-9);
            EXPECT_LT(difference(b.unit_load, a.unit_load), 1e-9);
            work = std::max(work, a.along_before);
            EXPECT_NEAR(b.along, a.along, 1e-9 * work);
            EXPECT_NEAR(b.along_before, a.along_before, 1e-9 * work);
            EXPECT_EQ(b.digest.yielding_points, a.digest.yielding_points);
            EXPECT_EQ(b.digest.status, a.digest.status);
            EXPECT_NEAR(b.digest.opening.at(0), a.digest.opening.at(0), 1e-9);
            opening = a.digest.opening;
        }
        const coupling::StepReport a = one.commit({}), b = team.together->commit({});
        EXPECT_GT(a.dissipation, 0.0);
        EXPECT_NEAR(b.dissipation, a.dissipation, 1e-9 * a.dissipation);
        EXPECT_NEAR(b.tips[0].CTOD, a.tips[0].CTOD, 1e-9);
        EXPECT_EQ(a.tips[0].opening, opening[0]) << "that of the trial state is the one that is committed";
        EXPECT_EQ(b.unknowns, a.unknowns);
        EXPECT_EQ(b.faces.size(), a.faces.size());
    }
    const coupling::ZoneState a = one.state(), b = team.together->state();
    EXPECT_LT(difference(b.displacement, a.displacement), 1e-9);
    const auto p = points_of(a), q = points_of(b);
    ASSERT_EQ(p.size(), q.size());
    for (std::size_t k = 0; k < p.size(); ++k)
        for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(q[k][c], p[k][c], 1e-7);
}

/// Has its answer only after somebody has waited for it.
class LateModel : public fine::FineModel {
public:
    LateModel(const Case& input, int rank, std::vector<int>& heard) : FineModel(input), rank_(rank), heard_(heard) {}

    [[nodiscard]] bool has_answered() override { return is_there; }
    void wait_a_moment() override { is_there = true; }
    coupling::PatchResponse collect() override {
        heard_.push_back(rank_);
        return FineModel::collect();
    }
    bool is_there = true;

private:
    int rank_;
    std::vector<int>& heard_;
};

TEST(FineRanksInTurn, WhoHasAnsweredIsHeardFirstAndTheSumHasTheSameBits) {
    const Case input = plate_case({{0.0, 4.4}, {5.6, 4.4}});
    const coupling::Patch patch = plate_patch(plate_mesh(11, 9, input));
    const Eigen::VectorXd u = random_vector(std::ssize(patch.boundary), 2e-3, 1);
    std::vector<int> heard;
    std::array<coupling::PatchResponse, 2> answers;
    for (const bool late : {false, true}) {
        LateModel first(input, 0, heard), second(input, 1, heard);
        coupling::FineRanks ranks({&first, &second}, 10);
        ranks.set_patch(patch);
        first.is_there = !late;
        answers[late ? 1 : 0] = answer(ranks, 0, u);
    }
    EXPECT_EQ(heard, (std::vector{0, 1, 1, 0}));
    EXPECT_EQ(answers[1].force, answers[0].force);
    EXPECT_EQ(whole(answers[1].tangent), whole(answers[0].tangent));
}

TEST_P(FineRanks, WorkOnAfterAFailure) {
    one.set_patch(patch);
    team.together->set_patch(patch);
    Eigen::VectorXd beyond = boundary(1e-3, 1);
    const Eigen::VectorXd rest = beyond;
    (void)answer(*team.together, 0, rest);
    beyond[0] = 1e300;
    EXPECT_THROW((void)answer(*team.together, 0, beyond), NumericalFailure);
    team.together->rollback();
    const coupling::PatchResponse a = answer(one, 0, rest), b = answer(*team.together, 0, rest);
    EXPECT_FALSE(b.same_tangent);
    EXPECT_LT(difference(whole(b.tangent), whole(a.tangent)), 1e-9);
}

/// In this process: it works while it is asked.
struct RankHere : fine::FineModel {
    using FineModel::FineModel;
    void set_patch(const coupling::Patch& patch) override {
        FineModel::set_patch(patch);
        ++worked;
    }
    coupling::PatchResponse collect() override {
        ++worked;
        return FineModel::collect();
    }
    coupling::StepReport commit(const coupling::Commit& what) override {
        ++worked;
        return FineModel::commit(what);
    }
    int worked = 0;
};

/// In another one: it has answered when the one here has done its part, which it should not have to wait for.
struct RankElsewhere : fine::FineModel {
    RankElsewhere(const Case& input, const RankHere& here) : FineModel(input), here_(here) {}
    void begin_set_patch(const coupling::Patch& /*patch*/) override { asked_at_ = here_.worked; }
    void request(const coupling::PatchDisplacement& displacement) override {
        asked_at_ = here_.worked;
        FineModel::request(displacement);
    }
    void begin_commit(const coupling::Commit& /*what*/) override { asked_at_ = here_.worked; }
    bool has_answered() override { return here_.worked > asked_at_; }
    void wait_a_moment() override { FAIL() << "the rank here sleeps while it has work to do"; }
    void set_patch(const coupling::Patch& patch) override {
        EXPECT_TRUE(has_answered());
        FineModel::set_patch(patch);
    }
    coupling::PatchResponse collect() override {
        EXPECT_TRUE(has_answered());
        return FineModel::collect();
    }
    coupling::StepReport commit(const coupling::Commit& what) override {
        EXPECT_TRUE(has_answered());
        return FineModel::commit(what);
    }

private:
    const RankHere& here_;
    int asked_at_ = 0;
};

TEST(FineRanksInTwoPlaces, WorkSideBySide) {
    const Case input = plate_case({{0.0, 4.4}, {5.6, 4.4}});
    const coupling::Patch patch = plate_patch(plate_mesh(11, 9, input));
    RankHere here(input);
    RankElsewhere elsewhere(input, here);
    coupling::FineRanks together({&elsewhere, &here}, 10);
    together.set_patch(patch);
    const Eigen::VectorXd u = random_vector(std::ssize(patch.boundary), 4e-3, 1);
    for (const int iteration : {0, 1, 2}) (void)answer(together, iteration, u);
    (void)together.commit({});
    EXPECT_EQ(here.worked, 5);
}

/// The crack turns and ties elements of two ranks together. One of them loses all that it has, but for an element that
/// is new with the next growth. It froze the tip that it had known once more, and the faces of all were too far apart:
/// K_I where they are pressed together was a tenth off.
TEST(IdleFineRanks, ForgetWhatOthersHaveTakenOver) {
    Case input = plate_case({{0.0, 11.7725}, {2.41092, 10.9022}});
    input.model.plane = PlaneState::Stress;
    input.mesh = {.specimen = "plate", .width = 10.0, .height = 20.0, .size = 0.7143, .grading = {}};
    input.material.yield_stress = 368.8;
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load.steps = 8;
    input.load.blocks = {{.cycles = 6, .max = 73.0, .min = -73.0}};
    input.fine.radius = 1.565;
    input.growth.emplace();
    input.growth->increment = 0.398;
    input.growth->every = 2;
    input.growth->at = GrowthAt::Minimum;
    input.solver.tolerance = 1e-10;
    Team one(input, 1), three(input, 3);
    const auto run = [&](Team& team) {
        coarse::CondensedFactory factory(team.together.get(), input);
        return run_analysis(input, factory);
    };
    const RunHistory a = run(one), b = run(three);
    ASSERT_EQ(a.increments.size(), b.increments.size());
    EXPECT_GT(three.together->history_moves(), 0);
    for (std::size_t k = 0; k < a.increments.size(); ++k)
        EXPECT_NEAR(b.increments[k].tips[0].K_I, a.increments[k].tips[0].K_I, 1e-6 * 300.0) << k;
}

// The crack turns where it begins to grow, and elements of the rings lie behind the bend.
TEST(FineRanksBehindABend, TellTheSameK) {
    Case input = plate_case({{0.0, 8.06896}, {2.37417, 7.4814}});
    input.mesh = {.specimen = "plate", .width = 10.0, .height = 20.0, .size = 0.9091, .grading = {}};
    input.material.yield_stress = 248.0;
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load.steps = 4;
    input.load.blocks = {{.cycles = 3, .max = 34.0, .min = 10.0}};
    input.fine.radius = 1.333;
    input.fine.refine = 8;
    input.growth.emplace();
    input.growth->increment = 0.127;
    input.solver.tolerance = 1e-11;
    const auto run = [&](int ranks) {
        Team team(input, ranks);
        coarse::CondensedFactory factory(team.together.get(), input);
        return run_analysis(input, factory);
    };
    const RunHistory one = run(1), two = run(2);
    ASSERT_EQ(one.increments.size(), two.increments.size());
    for (std::size_t k = 0; k < one.increments.size(); ++k) {
        EXPECT_NEAR(two.increments[k].tips[0].K_I, one.increments[k].tips[0].K_I, 1e-6) << k;
        EXPECT_NEAR(two.increments[k].tips[0].K_II, one.increments[k].tips[0].K_II, 1e-6) << k;
    }
}

TEST(IdleFineRanks, AreAskedForNothing) {
    const Case input = plate_case({{0.0, 4.4}, {5.6, 4.4}});
    const coupling::Patch patch = plate_patch(extract(plate_mesh(11, 9, input), {9, 10}));
    Team team(input, 3);
    team.together->set_patch(patch);  // a model without a patch would not survive a question
    (void)answer(*team.together, 0, Eigen::VectorXd::Zero(std::ssize(patch.boundary)));
    const coupling::StepReport report = team.together->commit({});
    team.together->rollback();
    EXPECT_EQ(report.points, 2 * 16);
    EXPECT_EQ(team.together->state().x.size(), 2U * 16U);
    EXPECT_EQ(team.together->reports()[1].points, 16);
    EXPECT_EQ(team.together->reports()[2].points, 0);
}

INSTANTIATE_TEST_SUITE_P(Number, FineRanks, testing::Values(1, 2, 3, 5));

}  // namespace
}  // namespace stria::test
