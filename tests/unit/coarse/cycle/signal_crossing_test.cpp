// Where a signal passes zero between two stations of a way, by what has been seen of it and what is expected.
#include "coarse/cycle/signal_crossing.hpp"

#include <gtest/gtest.h>

namespace stria::coarse {
namespace {

constexpr double of_answer = 0.1;  // of a target

/// Stations of one signal.
std::vector<ClosureStation> way_of(const std::vector<std::array<double, 2>>& stations) {
    std::vector<ClosureStation> way;
    for (const auto& [target, signal] : stations)
        way.push_back({.target = target, .load_factor = target, .signal = {signal}});
    return way;
}

Crossing between(const std::vector<ClosureStation>& way, std::size_t i, const ExpectedCrossing& expected = {}) {
    return crossing(way, i, 0, of_answer, expected);
}

TEST(SignalCrossing, IsTriedInProportionWhereNothingElseIsKnown) {
    const Crossing found = between(way_of({{0.0, 3.0}, {10.0, -1.0}}), 0);
    EXPECT_FALSE(found.known);
    EXPECT_DOUBLE_EQ(found.share, 0.75);
    EXPECT_DOUBLE_EQ(between(way_of({{0.0, 3.0}, {10.0, -INFINITY}}), 0).share, 0.5) << "it only says whether";
    EXPECT_DOUBLE_EQ(between(way_of({{0.0, 1.0}, {10.0, -1e-6}}), 0).share, 0.9) << "not at a station again";
}

// Straight to 4, while the other side, twice as stiff, leads to the same place.
TEST(SignalCrossing, IsWhereTwoStationsOnEitherSideLead) {
    const auto way = way_of({{0.0, 4.0}, {3.0, 1.0}, {6.0, -4.0}, {7.0, -6.0}});
    const Crossing found = between(way, 1);
    EXPECT_TRUE(found.known);
    EXPECT_NEAR(found.share, 1.0 / 3.0, 1e-14);
}

// Both sides lead to 5 from far away; faces that still touch there press less and less up to 7.
TEST(SignalCrossing, IsTriedWhereBothSidesLeadFromFarAway) {
    const Crossing found = between(way_of({{0.0, 10.0}, {3.0, 4.0}, {8.0, -1.5}, {9.0, -2.0}}), 1);
    EXPECT_FALSE(found.known);
    EXPECT_NEAR(found.share, 2.0 / 5.0, 1e-14);
}

TEST(SignalCrossing, IsTriedWhereTheStationsOnOneSideLead) {
    const Crossing before = between(way_of({{0.0, 4.0}, {3.0, 1.0}, {6.0, -9.0}}), 1);
    EXPECT_FALSE(before.known);
    EXPECT_NEAR(before.share, 1.0 / 3.0, 1e-14);
    const Crossing after = between(way_of({{3.0, 9.0}, {6.0, -4.0}, {7.0, -6.0}}), 0);
    EXPECT_FALSE(after.known);
    EXPECT_NEAR(after.share, 1.0 / 3.0, 1e-14);
    // To 4 and to 6: the station at 3 is nearer to where it leads.
    EXPECT_NEAR(between(way_of({{0.0, 4.0}, {3.0, 1.0}, {10.0, -4.0}, {12.0, -6.0}}), 1).share, 1.0 / 7.0, 1e-14);
}

TEST(SignalCrossing, IsKnownNearAStationThatLeadsThereAndWithinThePrecision) {
    EXPECT_TRUE(between(way_of({{0.0, 4.0}, {3.97, 0.03}, {10.0, -9.0}}), 1).known);
    EXPECT_FALSE(between(way_of({{0.0, 4.0}, {3.94, 0.06}, {10.0, -9.0}}), 1).known);
    EXPECT_TRUE(between(way_of({{0.0, 4.0}, {0.1, -9.0}}), 0).known);
    EXPECT_FALSE(between(way_of({{0.0, 4.0}, {0.11, -9.0}}), 0).known);
}

TEST(SignalCrossing, IsTriedFirstWhereItIsExpectedAndThenBesideIt) {
    const ExpectedCrossing expected{.target = 6.0, .rate = {-2.0, -0.5}};  // open, closed
    EXPECT_DOUBLE_EQ(between(way_of({{0.0, 3.0}, {10.0, -1.0}}), 0, expected).share, 0.6);
    // It is closed still where it was expected to come to zero: by its rate it does so 0.4 later.
    const Crossing later = between(way_of({{0.0, 3.0}, {6.0, 0.2}, {10.0, -1.0}}), 1, expected);
    EXPECT_FALSE(later.known);
    EXPECT_NEAR(later.share, 0.4 / 4.0, 1e-14);
    // Open already: 0.2 earlier.
    EXPECT_NEAR(between(way_of({{0.0, 3.0}, {6.0, -0.4}, {10.0, -1.0}}), 0, expected).share, 1.0 - 0.2 / 6.0, 1e-14);
    // Within what the answer may be off by nothing is tried: nearly the precision away.
    EXPECT_NEAR(between(way_of({{6.0, 0.01}, {10.0, -1.0}}), 0, expected).share, 0.09 / 4.0, 1e-14);
}

TEST(SignalCrossing, IsAStationAtWhichItIsZeroButForRounding) {
    const ExpectedCrossing expected{.target = NAN, .rate = {-2.0, -0.5}};
    const Crossing found = between(way_of({{0.0, 1e-9}, {10.0, -1.0}}), 0, expected);
    EXPECT_TRUE(found.known);
    EXPECT_NEAR(found.share, 0.0, 1e-9);
}

TEST(SignalCrossing, RatesAreThoseOfTheNearestStationNeitherOnItNorFarAway) {
    const auto way = way_of({{0.0, 8.0}, {3.5, 0.6}, {3.99, 0.02}, {4.3, -0.9}, {9.0, -50.0}});
    const auto [open, closed] = rates_beside(way, 2, 0, of_answer, 4.0);
    EXPECT_DOUBLE_EQ(closed, -1.2);
    EXPECT_DOUBLE_EQ(open, -3.0);
    const auto far = rates_beside(way_of({{0.0, 4.0}, {9.0, -5.0}}), 0, 0, of_answer, 4.0);
    EXPECT_TRUE(std::isnan(far[0]) && std::isnan(far[1]));
}

}  // namespace
}  // namespace stria::coarse
