// What a zone remembers can be parted and put together again.
#include "coupling/zone_snapshot.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "common/enrichment/part_of_mesh.hpp"
#include "common/index.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

using coupling::ZoneSnapshot;

/// Of 4 x 2 elements with a crack in the lower row; element e has e % 3 points of two numbers each.
class SnapshotOfZone : public testing::Test {
protected:
    SnapshotOfZone() {
        whole.ranks = 2;
        whole.columns = 2;
        whole.half_cycle_ended = true;
        for (int e = 0; e < 8; ++e) {
            whole.element.push_back(e);
            whole.rank.push_back(e / 4);
            whole.points.push_back(e % 3);
            whole.recent_flow.push_back(10 + e);
            whole.unknowns.push_back(1 + e % 2);
            whole.resting.push_back(e % 2);
            whole.flow.push_back(0.1 * e);
            for (int row = 0; row < e % 3; ++row)
                for (const double number : {0.0, 0.5}) whole.history.push_back(100.0 * e + row + number);
            for (int i = 0; i <= e % 2; ++i) whole.stand.push_back(10.0 * e + i);
        }
        const auto numbered = [&](double first) { return Eigen::VectorXd::LinSpaced(size, first, first + 1.0); };
        whole.displacement = numbered(0.0);
        whole.rest_displacement = numbered(2.0);
        whole.held = numbered(4.0);
        whole.increments = {numbered(6.0), numbered(8.0)};
        whole.multipliers.resize(1);  // of crack 0
        whole.frozen_tips.resize(1);
        whole.frozen_tips[0].crack = 0;
    }

    Case input = plate_case({{0.0, 0.5}, {2.5, 0.5}});
    EnrichedMesh zone = plate_mesh(4, 2, input);
    Eigen::Index size = zone.unknowns;
    ZoneSnapshot whole;
};

TEST_F(SnapshotOfZone, KnowsWhereTheHistoryOfAnElementIs) {
    const auto histories = histories_of_elements(whole);
    EXPECT_EQ(histories[5].first_row, 0U + 1U + 2U + 0U + 1U);
    EXPECT_EQ(histories[5].rows, 2U);
    EXPECT_EQ(histories[5].first_unknown, 1U + 2U + 1U + 2U + 1U);
    EXPECT_EQ(histories[5].unknowns, 2U);
}

// Elements in the order of the part, whatever the whole's.
TEST_F(SnapshotOfZone, GivesAPartWhatIsItsOwn) {
    const EnrichedMesh upper = extract(zone, {5, 7});
    const std::vector<int> unknowns{3, 1};
    const ZoneSnapshot part = part_of(whole, upper, unknowns);
    EXPECT_EQ(part.element, (std::vector{5, 7}));
    EXPECT_EQ(part.recent_flow, (std::vector{15, 17}));
    EXPECT_EQ(part.history, (std::vector{500.0, 500.5, 501.0, 501.5, 700.0, 700.5}));
    EXPECT_EQ(part.stand, (std::vector{50.0, 51.0, 70.0, 71.0}));
    EXPECT_EQ(part.displacement, Eigen::Vector2d(whole.displacement[3], whole.displacement[1]));
    EXPECT_EQ(part.increments.at(1), Eigen::Vector2d(whole.increments[1][3], whole.increments[1][1]));
    EXPECT_TRUE(part.half_cycle_ended);
    EXPECT_TRUE(part.multipliers.empty()) << "no piece of its crack is there";
    EXPECT_TRUE(part.frozen_tips.empty());
    EXPECT_EQ(part_of(whole, extract(zone, {0, 1}), unknowns).multipliers.size(), 1U);
}

TEST_F(SnapshotOfZone, IsTheSumOfItsParts) {
    std::vector<int> all(at(size)), lower, upper;
    std::iota(all.begin(), all.end(), 0);
    for (const int unknown : all) (unknown % 2 == 0 ? lower : upper).push_back(unknown);
    ZoneSnapshot sum;
    sum.ranks = 2;
    sum.displacement = sum.rest_displacement = sum.held = Eigen::VectorXd::Zero(size);
    sum.increments.resize(2, Eigen::VectorXd::Zero(size));
    add(sum, part_of(whole, extract(zone, {0, 1, 2, 3}), lower), 0, lower);
    add(sum, part_of(whole, extract(zone, {4, 5, 6, 7}), upper), 1, upper);
    EXPECT_EQ(sum.element, whole.element);
    EXPECT_EQ(sum.rank, whole.rank);
    EXPECT_EQ(sum.history, whole.history);
    EXPECT_EQ(sum.stand, whole.stand);
    EXPECT_EQ(sum.flow, whole.flow);
    EXPECT_EQ(sum.displacement, whole.displacement);
    EXPECT_EQ(sum.rest_displacement, whole.rest_displacement);
    EXPECT_EQ(sum.increments, whole.increments);
    EXPECT_EQ(sum.held, whole.held);
    EXPECT_EQ(sum.multipliers.size(), 1U);
}

}  // namespace
}  // namespace stria::test
