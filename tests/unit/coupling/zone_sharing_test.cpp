// Who has which elements of the zone from patch to patch, and what of late has flowed in them.
#include "coupling/ranks/zone_sharing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/enrichment/part_of_mesh.hpp"
#include "common/index.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

/// 12 x 9 elements without a crack, shared by two.
class SharedZone : public testing::Test {
protected:
    SharedZone() {
        patch.mesh = plate_mesh(12, 9, Case());
        moved_at_first = sharing.turn_to(patch, {}, 0);
        sharing.arrive();
    }

    [[nodiscard]] bool turns_to(const coupling::Patch& next) {
        const bool moves = sharing.turn_to(next, patch.mesh, 2);
        sharing.arrive();
        return moves;
    }
    /// So many iterations in which the elements of rank 0 yield, and no others.
    void flow_with_first(int iterations) {
        coupling::Digest digest;
        for (const auto& [id, rank] : sharing.owner()) digest.yielding_points.push_back(rank == 0 ? 1 : 0);
        for (int k = 0; k < iterations; ++k) sharing.note(digest);
    }
    /// Of what flows the part of rank 0.
    [[nodiscard]] double share_of_first() const {
        double first = 0.0, all = 0.0;
        for (const auto& [id, rank] : sharing.owner()) {
            all += sharing.flow()[at(id)];
            if (rank == 0) first += sharing.flow()[at(id)];
        }
        return first / all;
    }

    coupling::Patch patch;
    coupling::ZoneSharing sharing{2};
    bool moved_at_first = true;
};

TEST_F(SharedZone, BeginsWithoutHistory) {
    EXPECT_FALSE(moved_at_first);
    EXPECT_EQ(sharing.owner().size(), 108U);
    EXPECT_EQ(sharing.flow(), std::vector<double>(108, 0.0));
    EXPECT_GT(sharing.weighed_cost(), 0.0);
}

TEST_F(SharedZone, CountsRecentIterationsMost) {
    flow_with_first(2);
    EXPECT_DOUBLE_EQ(std::ranges::max(sharing.flow()), 1.0 - 63.0 * 63.0 / (64.0 * 64.0));
    EXPECT_EQ(std::ranges::min(sharing.flow()), 0.0);
}

TEST_F(SharedZone, IsSharedAnewWhereOneHasAllTheFlow) {
    flow_with_first(500);
    EXPECT_EQ(share_of_first(), 1.0);
    EXPECT_TRUE(turns_to(patch));
    EXPECT_NEAR(share_of_first(), 0.5, 0.1);
    const double cost = sharing.weighed_cost();
    EXPECT_FALSE(turns_to(patch)) << "the cost is the one that was looked at";
    EXPECT_EQ(sharing.weighed_cost(), cost);
}

TEST_F(SharedZone, StaysWhereLittleIsGained) {
    flow_with_first(1);
    const std::map<int, int> before = sharing.owner();
    EXPECT_FALSE(turns_to(patch));
    EXPECT_EQ(sharing.owner(), before);
}

TEST_F(SharedZone, StaysWhileElementsAreSplit) {
    flow_with_first(500);
    coupling::Patch next = patch;
    next.part_of.assign(108, -1);
    EXPECT_FALSE(turns_to(next));
    EXPECT_EQ(share_of_first(), 1.0);
}

// Of an element with another number its own, of a part that of its whole.
TEST_F(SharedZone, KnowsTheFlowOfElementsAndPartsById) {
    flow_with_first(1);
    const int flows = static_cast<int>(std::ranges::find(sharing.flow(), 1.0 / 64.0) - sharing.flow().begin()),
              rests = static_cast<int>(std::ranges::find(sharing.flow(), 0.0) - sharing.flow().begin());
    coupling::Patch next;
    next.mesh = extract(patch.mesh, {std::min(flows, rests), std::max(flows, rests)});
    next.part_of = {std::max(flows, rests), -1};
    static_cast<void>(turns_to(next));
    const double of_both = flows > rests ? 1.0 / 64.0 : 0.0;
    EXPECT_EQ(sharing.flow(), (std::vector{of_both, of_both}));
}

TEST_F(SharedZone, GoesOnFromASnapshotOfAsManyRanks) {
    coupling::ZoneSnapshot snapshot;
    snapshot.ranks = 2;
    snapshot.weighed_cost = 7.0;
    for (int e = 0; e < 108; ++e) {
        snapshot.element.push_back(e);
        snapshot.rank.push_back(e % 2);
        snapshot.flow.push_back(0.01 * e);
    }
    sharing.resume(patch, snapshot);
    EXPECT_EQ(sharing.owner().at(17), 1);
    EXPECT_EQ(sharing.weighed_cost(), 7.0);
    EXPECT_EQ(sharing.flow(), snapshot.flow);
    coupling::ZoneSharing three(3);
    three.resume(patch, snapshot);
    EXPECT_EQ(three.weighed_cost(), 0.0) << "nobody has thought of another sharing yet";
    EXPECT_TRUE(std::ranges::any_of(three.owner(), [](const auto& owned) { return owned.second == 2; }));
}

}  // namespace
}  // namespace stria::test
