#include "common/enrichment/part_of_mesh.hpp"
#include "coupling/ranks/zone_partition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "common/enrichment/element_basis.hpp"
#include "common/index.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

using coupling::share_on, coupling::share_out;

std::set<int> ranks_in(const std::vector<int>& rank) { return {rank.begin(), rank.end()}; }

std::map<int, int> owners_of(const EnrichedMesh& mesh, const std::vector<int>& rank) {
    std::map<int, int> owners;
    for (std::size_t e = 0; e < rank.size(); ++e) owners[mesh.element_ids[e]] = rank[e];
    return owners;
}

/// Ranks of the elements that carry pieces of a crack or see its functions.
std::set<int> ranks_of_cracks(const EnrichedMesh& zone, const std::vector<int>& rank) {
    const std::vector<int> piece = piece_of_elements(zone);
    std::set<int> found;
    for (int e = 0; e < std::ssize(zone.elements); ++e) {
        const auto i = at(e);
        if (ElementBasis(zone, e, piece[i] >= 0).enriched() || piece[i] >= 0) found.insert(rank[i]);
    }
    return found;
}

/// 12 x 9 elements; the crack enters from the left and ends in the middle of one.
class ZonePartition : public testing::Test {
protected:
    Case input = plate_case({{0.0, 4.4}, {5.6, 4.4}});
    EnrichedMesh zone = plate_mesh(12, 9, input);
};

TEST_F(ZonePartition, BalancesElements) {
    for (const int ranks : {1, 2, 3, 4, 6}) {
        const std::vector<int> rank = share_out(zone, ranks);
        EXPECT_EQ(std::ssize(ranks_in(rank)), ranks);
        for (int r = 0; r < ranks; ++r) EXPECT_LE(std::abs(std::ranges::count(rank, r) - 108 / ranks), 12) << r;
    }
}

TEST_F(ZonePartition, WhatSeesACrackStaysTogether) { EXPECT_EQ(ranks_of_cracks(zone, share_out(zone, 4)).size(), 1U); }

TEST_F(ZonePartition, MoreRanksThanElementsLeaveTheLastWithoutAny) {
    const EnrichedMesh small = extract(zone, {8, 9, 10});
    EXPECT_EQ(share_out(small, 7), (std::vector<int>{0, 1, 2}));
}

TEST_F(ZonePartition, ElementsKeepTheirRankAndNewOnesJoinANeighbour) {
    std::vector<int> first(96);
    std::iota(first.begin(), first.end(), 0);  // all rows but the uppermost
    const EnrichedMesh before = extract(zone, first);
    const std::vector<int> earlier = share_out(before, 3);
    const std::vector<int> later = share_on(zone, owners_of(before, earlier)).value();
    for (std::size_t e = 0; e < 96; ++e) EXPECT_EQ(later[e], earlier[e]);
    for (std::size_t e = 96; e < 108; ++e) {
        std::set<int> below;
        for (std::size_t k = 84; k < 96; ++k)
            if (std::abs(static_cast<int>(k + 12 - e)) <= 1) below.insert(earlier[k]);
        EXPECT_TRUE(below.contains(later[e]) || later[e] == later[e - 1]) << e;
    }
}

/// A crack that flows outweighs all else: it has a rank of its own, and each of the others one element at least.
TEST_F(ZonePartition, NobodyIdlesBesideAHeavyCrack) {
    std::vector<double> flow(108, 0.0);
    for (int e = 48; e < 60; ++e) flow[at(e)] = 1.0;  // its row
    for (const int ranks : {2, 3, 4, 5, 7})
        EXPECT_EQ(std::ssize(ranks_in(share_out(zone, ranks, {}, {}, flow))), ranks);
}

/// 108 elements in two parts: 10 nodes on the seam across the plate, 13 along it.
TEST_F(ZonePartition, TakesTheShorterSeam) {
    const auto x = [](const EnrichedMesh& mesh, int element) { return mesh.nodes[at(mesh.elements[at(element)][0])]; };
    const EnrichedMesh wide = plate_mesh(12, 9, Case()), high = plate_mesh(9, 12, Case());
    const std::vector<int> of_wide = share_out(wide, 2), of_high = share_out(high, 2);
    for (int e = 0; e < 108; ++e) {
        EXPECT_EQ(of_wide[at(e)], x(wide, e).x() < 5.5 ? 0 : 1);
        EXPECT_EQ(of_high[at(e)], x(high, e).y() < 5.5 ? 0 : 1);
    }
}

TEST_F(ZonePartition, ElementsThatYieldCountMore) {
    std::vector<double> flow(108, 0.0);
    for (int e = 0; e < 108; ++e)
        if (zone.nodes[at(zone.elements[at(e)][0])].y() < 2.5) flow[at(e)] = 1.0;  // three of nine rows
    const std::vector<int> blind = share_out(zone, 2), rank = share_out(zone, 2, {}, {}, flow);
    // 54 or 60 elements and 36 of them that yield; about half of either in the better way. And the seams.
    EXPECT_GT(coupling::cost_of_sharing(zone, blind, flow), 54.0 + 20.0 * 36.0);
    EXPECT_LT(coupling::cost_of_sharing(zone, rank, flow), 65.0 + 20.0 * 20.0 + 20.0);
    EXPECT_EQ(ranks_of_cracks(zone, rank).size(), 1U);
}

TEST_F(ZonePartition, ACrackThatGoesStraightOnStaysWithItsRank) {
    for (const int ranks : {2, 3, 4}) {
        const EnrichedMesh shorter = plate_mesh(12, 9, input, 0);
        const std::vector<int> earlier = share_out(shorter, ranks);
        for (const double tip : {6.6, 8.6, 11.6}) {
            const EnrichedMesh longer = plate_mesh(12, 9, plate_case({{0.0, 4.4}, {tip, 4.4}}), 0);
            EXPECT_EQ(share_on(longer, owners_of(zone, earlier)), earlier) << ranks << " ranks, " << tip;
        }
    }
}

TEST_F(ZonePartition, IsMadeAnewWhereALongerCrackCutsElementsOfAnotherRank) {
    const std::vector<int> earlier = share_out(zone, 2);
    EXPECT_EQ(share_on(zone, owners_of(zone, earlier)), earlier);
    const EnrichedMesh longer = plate_mesh(12, 9, plate_case({{0.0, 4.4}, {5.6, 4.4}, {8.6, 0.6}}));
    EXPECT_FALSE(share_on(longer, owners_of(zone, earlier)).has_value());
    const std::vector<int> later = share_out(longer, 2, zone);
    EXPECT_EQ(ranks_of_cracks(longer, later).size(), 1U);
    EXPECT_EQ(ranks_of_cracks(zone, later).size(), 1U);
    EXPECT_LE(std::abs(std::ranges::count(later, 0) - 54), 12);
}

/// What either mesh ties together, for history moves while they are apart.
TEST(CracksThatMeet, EndOnOneRank) {
    const auto plate = [](double left, double right) {
        return with_hanging_node(plate_mesh(12, 9, two_cracks(left, right, 12.0)), {6.0, 4.0});
    };
    const EnrichedMesh apart = plate(3.6, 8.4), together = plate(6.6, 6.4);
    const std::vector<int> earlier = share_out(apart, 2);
    EXPECT_EQ(ranks_of_cracks(apart, earlier), (std::set<int>{0, 1}));
    EXPECT_FALSE(share_on(together, owners_of(apart, earlier)).has_value());
    const std::vector<int> later = share_out(together, 2, apart);
    EXPECT_EQ(ranks_of_cracks(together, later).size(), 1U);
    EXPECT_EQ(ranks_of_cracks(apart, later), ranks_of_cracks(together, later));
    EXPECT_EQ(ranks_in(later).size(), 2U);
}

}  // namespace
}  // namespace stria::test
