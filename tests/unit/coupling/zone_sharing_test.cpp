// Who has which elements of the zone from patch to patch, and what of late has flowed in them.
#include "coupling/ranks/zone_sharing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/enrichment/part_of_mesh.hpp"
#include "common/index.hpp"
#include "coupling/ranks/zone_partition.hpp"
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
    /// Of each element, in their order.
    [[nodiscard]] static std::vector<int> ranks_of(const coupling::ZoneSharing& sharing) {
        std::vector<int> ranks;
        for (const auto& [id, rank] : sharing.owner()) ranks.push_back(rank);
        return ranks;
    }
    [[nodiscard]] coupling::ZoneSnapshot as_snapshot() const {
        coupling::ZoneSnapshot snapshot;
        snapshot.ranks = 2;
        snapshot.flow = sharing.flow();
        for (const auto& [id, rank] : sharing.owner()) {
            snapshot.element.push_back(id);
            snapshot.rank.push_back(rank);
        }
        return snapshot;
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
    EXPECT_EQ(sharing.weighed_cost(), coupling::cost_of_sharing(patch.mesh, ranks_of(sharing), sharing.flow()));
}

// Rank 0 has all the flow, and another sharing would cost much less.
TEST_F(SharedZone, LooksAtAnotherSharingWhereTheCostIsAnotherOne) {
    flow_with_first(500);
    coupling::ZoneSnapshot snapshot = as_snapshot();
    const double cost = coupling::cost_of_sharing(patch.mesh, snapshot.rank, snapshot.flow);
    for (const auto& [weighed, looks] : {std::pair{1.07, true}, {1.04, false}, {0.96, false}, {0.94, true}}) {
        snapshot.weighed_cost = weighed * cost;
        sharing.resume(patch, snapshot);
        EXPECT_EQ(turns_to(patch), looks) << weighed;
    }
}

// Who has lost all elements gets none by a new sharing.
TEST_F(SharedZone, IsSharedAnewByWhoeverHasElements) {
    flow_with_first(500);
    coupling::ZoneSnapshot snapshot = as_snapshot();
    snapshot.ranks = 3;
    sharing = coupling::ZoneSharing(3);
    sharing.resume(patch, snapshot);
    EXPECT_TRUE(turns_to(patch));
    EXPECT_EQ(std::ranges::max(ranks_of(sharing)), 1);
}

// History moves under the mesh that was, where what a crack cuts belongs to one rank.
TEST_F(SharedZone, IsSharedAnewSoThatThePresentCracksStayWhole) {
    const Case cracked = plate_case({{0.0, 4.5}, {11.5, 4.5}});
    const EnrichedMesh present = plate_mesh(12, 9, cracked);
    flow_with_first(500);
    EXPECT_TRUE(sharing.turn_to(patch, present, 2));
    for (int column = 1; column < 12; ++column)
        EXPECT_EQ(sharing.owner().at(4 * 12 + column), sharing.owner().at(4 * 12)) << column;
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

// The first part of an element has the element's number, the others have new ones; they need not touch it.
TEST_F(SharedZone, GivesPartsTheRankOfTheirWhole) {
    const std::vector<int> ranks = ranks_of(sharing);
    const auto first_of = [&](int rank) { return static_cast<int>(std::ranges::find(ranks, rank) - ranks.begin()); };
    for (const int rank : {0, 1}) {
        coupling::ZoneSharing begun(2);
        EXPECT_FALSE(begun.turn_to(patch, {}, 0));
        coupling::Patch next;
        const int whole = first_of(rank), beside = first_of(1 - rank), far = 107;
        std::vector<int> elements{whole, beside, far};
        std::ranges::sort(elements);
        next.mesh = extract(patch.mesh, elements);
        next.mesh.element_ids = std::vector{elements[0], elements[1], 1000};
        for (const int e : elements) next.part_of.push_back(e == beside ? -1 : whole);
        EXPECT_FALSE(begun.turn_to(next, patch.mesh, 2));
        EXPECT_EQ(begun.owner(), (std::map<int, int>{{whole, rank}, {beside, 1 - rank}, {1000, rank}}));
    }
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

TEST_F(SharedZone, IsSharedOutByItsFlowForOtherRanks) {
    flow_with_first(500);
    const coupling::ZoneSnapshot snapshot = as_snapshot();
    sharing = coupling::ZoneSharing(3);
    sharing.resume(patch, snapshot);
    std::vector<double> flow(3, 0.0);
    for (const auto& [id, rank] : sharing.owner()) flow[at(rank)] += sharing.flow()[at(id)];
    const double all = flow[0] + flow[1] + flow[2];
    for (const double of_rank : flow) EXPECT_NEAR(of_rank, all / 3.0, 0.1 * all);
}

}  // namespace
}  // namespace stria::test
