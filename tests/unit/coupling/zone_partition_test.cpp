#include "coupling/zone_partition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "common/error.hpp"
#include "common/fem/element_basis.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

using coupling::share_out;

std::set<int> ranks_in(const std::vector<int>& rank) { return {rank.begin(), rank.end()}; }

/// 12 x 9 elements; the crack enters from the left and ends in the middle of one.
class ZonePartition : public testing::Test {
protected:
    Case input = plate_case({{0.0, 4.4}, {5.6, 4.4}});
    EnrichedMesh zone = plate_mesh(12, 9, input);
};

TEST_F(ZonePartition, BalancesElements) {
    for (const int ranks : {1, 2, 3, 4, 6}) {
        const std::vector<int> rank = share_out(zone, ranks, {});
        EXPECT_EQ(std::ssize(ranks_in(rank)), ranks);
        for (int r = 0; r < ranks; ++r) EXPECT_LE(std::abs(std::ranges::count(rank, r) - 108 / ranks), 12) << r;
    }
}

TEST_F(ZonePartition, WhatSeesACrackStaysTogether) {
    const std::vector<int> rank = share_out(zone, 4, {}), piece = piece_of_elements(zone);
    std::set<int> of_crack;
    for (int e = 0; e < std::ssize(zone.elements); ++e) {
        const auto i = static_cast<std::size_t>(e);
        if (ElementBasis(zone, e, piece[i] >= 0).enriched() || piece[i] >= 0) of_crack.insert(rank[i]);
    }
    EXPECT_EQ(of_crack.size(), 1U);
}

TEST_F(ZonePartition, MoreRanksThanElementsLeaveTheLastWithoutAny) {
    const EnrichedMesh small = extract(zone, {8, 9, 10});
    EXPECT_EQ(share_out(small, 7, {}), (std::vector<int>{0, 1, 2}));
}

TEST_F(ZonePartition, ElementsKeepTheirRankAndNewOnesJoinANeighbour) {
    std::vector<int> first(96);
    std::iota(first.begin(), first.end(), 0);  // all rows but the uppermost
    const EnrichedMesh before = extract(zone, first);
    const std::vector<int> earlier = share_out(before, 3, {});
    std::map<int, int> owners;
    for (std::size_t e = 0; e < earlier.size(); ++e) owners[before.element_ids[e]] = earlier[e];
    const std::vector<int> later = share_out(zone, 3, owners);
    for (std::size_t e = 0; e < 96; ++e) EXPECT_EQ(later[e], earlier[e]);
    for (std::size_t e = 96; e < 108; ++e) {
        std::set<int> below;
        for (std::size_t k = 84; k < 96; ++k)
            if (std::abs(static_cast<int>(k + 12 - e)) <= 1) below.insert(earlier[k]);
        EXPECT_TRUE(below.contains(later[e]) || later[e] == later[e - 1]) << e;
    }
}

TEST_F(ZonePartition, HistoryOfACutElementDoesNotMove) {
    const std::vector<int> rank = share_out(zone, 2, {});
    std::map<int, int> owners;
    for (std::size_t e = 0; e < rank.size(); ++e) owners[zone.element_ids[e]] = rank[e];
    const Case grown = plate_case({{0.0, 4.4}, {11.6, 4.4}});
    EXPECT_NO_THROW((void)share_out(zone, 2, owners));
    EXPECT_THROW((void)share_out(plate_mesh(12, 9, grown), 2, owners), CaseError);
}

}  // namespace
}  // namespace stria::test
