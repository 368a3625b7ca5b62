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
    // Without a rate as far as the answer may be off.
    EXPECT_NEAR(between(way_of({{6.0, 0.01}, {10.0, -1.0}}), 0, {.target = 6.0}).share, 0.09 / 4.0, 1e-14);
}

// A rate three times the present one, or a third of it, leaves the answer within the precision.
TEST(SignalCrossing, IsKnownFromAStationBesideItByTheRateOfCyclesBefore) {
    const ExpectedCrossing expected{.target = 6.0, .rate = {-2.0, -0.5}};  // open, closed
    const Crossing closed = between(way_of({{0.0, 3.0}, {6.0, 0.024}, {10.0, -1.0}}), 1, expected);
    EXPECT_TRUE(closed.known);
    EXPECT_NEAR(closed.share, 0.048 / 4.0, 1e-14);
    EXPECT_FALSE(between(way_of({{0.0, 3.0}, {6.0, 0.026}, {10.0, -1.0}}), 1, expected).known);
    const Crossing open = between(way_of({{0.0, 3.0}, {6.0, -0.09}, {10.0, -8.4}}), 0, expected);
    EXPECT_TRUE(open.known);
    EXPECT_NEAR(open.share, 1.0 - 0.045 / 6.0, 1e-14);
    EXPECT_FALSE(between(way_of({{0.0, 3.0}, {6.0, -0.11}, {10.0, -8.4}}), 0, expected).known);
}

// What has been seen leads 0.3 off, or nothing has been seen and it was expected elsewhere.
TEST(SignalCrossing, IsNotKnownByARateThatNothingElseSupports) {
    const ExpectedCrossing old{.target = 6.0, .rate = {-70.0, -70.0}};
    EXPECT_FALSE(between(way_of({{0.0, 6.3}, {6.0, 0.3}, {10.0, -1.0}}), 1, old).known);
    EXPECT_FALSE(between(way_of({{0.0, 6.3}, {6.0, -0.3}, {7.0, -1.3}}), 0, old).known);
    EXPECT_FALSE(between(way_of({{5.7, 0.3}, {10.0, -9.0}}), 0, old).known);
    EXPECT_TRUE(between(way_of({{5.9, 0.3}, {10.0, -9.0}}), 0, old).known);
}

TEST(SignalCrossing, SeriesGoOnAsTheirChangesFade) {
    EXPECT_DOUBLE_EQ(next_in_series(6.0, 8.0, 9.0), 9.5);
    EXPECT_DOUBLE_EQ(next_in_series(9.0, 8.0, 7.0), 6.0);
    EXPECT_DOUBLE_EQ(next_in_series(1.0, 1.1, 3.0), 3.1) << "a leap is no series";
    EXPECT_DOUBLE_EQ(next_in_series(1.0, 3.0, 2.0), 2.0) << "nor is what turns";
    EXPECT_DOUBLE_EQ(next_in_series(1.0, 1.0, 1.0), 1.0);
    EXPECT_DOUBLE_EQ(next_in_series(NAN, 1.0, 3.0), 3.0);
    EXPECT_DOUBLE_EQ(next_in_series(NAN, NAN, 3.0), 3.0);
    EXPECT_TRUE(std::isnan(next_in_series(NAN, NAN, NAN)));
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
