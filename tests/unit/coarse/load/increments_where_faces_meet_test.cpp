// Increments that the program chooses where faces meet, or are pressed together.
#include "coarse/load/increment_schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/measured_legs.hpp"

namespace stria::coarse {
namespace {

// Where faces meet an increment ends, and there are no more of them; of two places that are nearly one the first. The
// increments in which faces close begin small.
TEST(IncrementSchedule, EndsAnIncrementWhereFacesMeet) {
    IncrementSchedule schedule{LoadSection()};
    const std::size_t ends = schedule.ways(false).size();
    schedule.meet_at({0.7, 0.415, 0.42});
    const std::vector<double>& ways = schedule.ways(false);
    EXPECT_EQ(ways.size(), ends);
    EXPECT_TRUE(std::ranges::is_sorted(ways));
    for (const double place : {0.0, 0.415, 0.7, 1.0}) EXPECT_EQ(std::ranges::count(ways, place), 1) << place;
    EXPECT_EQ(std::ranges::count(ways, 0.42), 0);
    for (const double beside : {-0.01, 0.0, 0.01}) {  // the place of another end, or next to it
        schedule.meet_at({graded_ways(static_cast<int>(ends) - 2, LoadSection().power())[2] + beside});
        EXPECT_EQ(schedule.ways(false).size(), ends) << beside;
    }
    schedule.meet_at({0.3});
    const auto closing = std::ranges::find(schedule.ways(false), 0.3);
    ASSERT_GT(schedule.ways(false).end() - closing, 3);
    for (auto way = closing + 2; way != schedule.ways(false).end(); ++way)
        EXPECT_GT(way[0] - way[-1], way[-1] - way[-2]);
    schedule.meet_at({0.3, 0.33});  // the first stays
    EXPECT_EQ(std::ranges::count(schedule.ways(false), 0.3), 1);
    schedule.meet_at({0.1, 0.3, 0.5, 0.8});  // behind many tips
    EXPECT_EQ(schedule.ways(false).size(), ends);
    EXPECT_EQ(schedule.ways(false).back(), 1.0);
    schedule.meet_at({0.01, 0.99});
    EXPECT_EQ(schedule.ways(false), graded_ways(static_cast<int>(ends) - 1, LoadSection().power()));
    schedule.meet_at({});
    EXPECT_EQ(schedule.ways(false), graded_ways(static_cast<int>(ends) - 1, LoadSection().power()));
    IncrementSchedule given(LoadSection{.steps = 16, .blocks = {}});
    given.meet_at({0.415});
    EXPECT_EQ(std::ranges::count(given.ways(false), 0.415), 0) << "a number that is given still means that number";
}

// Before faces meet the tip flows back, and no opening tells later what that was off by.
TEST(IncrementSchedule, TakesFourBeforeFacesMeetOnTheWayIntoCompression) {
    const auto before = [](const LoadSection& load, bool presses) {
        IncrementSchedule schedule{load};
        schedule.meet_at({0.45}, presses);
        const std::vector<double>& ways = schedule.ways(false);
        EXPECT_TRUE(std::ranges::is_sorted(ways));
        EXPECT_EQ(std::ranges::count(ways, 0.45), 1);
        return std::ranges::find(ways, 0.45) - ways.begin();
    };
    EXPECT_EQ(before({}, true), 4);
    EXPECT_LT(before({}, false), 3);
    EXPECT_EQ(before({.accuracy = 0.0005, .blocks = {}}, true), 7);
}

// However many there are: else those that a measurement adds would all come behind that place.
TEST(IncrementSchedule, SharesThemBeforeAndBehindWhereFacesMeet) {
    IncrementSchedule schedule{LoadSection()};
    IncrementSchedule::State state = schedule.state();
    state.falling.increments = 24;
    schedule.resume(state);
    schedule.meet_at({0.4}, true);
    const std::vector<double>& ways = schedule.ways(false);
    EXPECT_EQ(ways.size(), 25U);
    for (std::size_t k = 0; k <= 10; ++k) EXPECT_NEAR(ways[k], 0.04 * static_cast<double>(k), 1e-12);
    schedule.meet_at({0.06}, true);  // no splinters
    EXPECT_EQ(schedule.ways(false)[3], 0.06);
    EXPECT_EQ(schedule.ways(false).size(), 25U);
    schedule.meet_at({0.94}, true);
    EXPECT_EQ(schedule.ways(false).size(), 1U + 10U + 3U);
}

// What few of them leave behind is off by ten times the accuracy in a cycle or two, and what few of them tell, tried as
// fewer, is half of the number that it takes. The opening must be known, or nothing would be measured ever.
TEST(IncrementSchedule, HasManyOnTheWayIntoCompressionUntilOneIsMeasured) {
    const auto numbers = [](double opening, const std::vector<double>& meetings, bool presses, bool measured) {
        IncrementSchedule schedule{LoadSection()};
        IncrementSchedule::State state = schedule.state();
        for (IncrementSchedule::Legs* legs : {&state.rising, &state.falling}) legs->knows_pressing = measured;
        schedule.resume(state);
        schedule.begin({opening});
        schedule.meet_at(meetings, presses);
        return std::pair{schedule.ways(false).size() - 1, schedule.ways(true).size() - 1};
    };
    const std::size_t begins = LoadSection().first_steps() / 2;
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(numbers(1.0, {}, true, false), (std::pair<std::size_t, std::size_t>{20, 12})) << "the first leg";
    EXPECT_EQ(numbers(1.0, {0.4}, true, false).first, 20U);
    EXPECT_EQ(numbers(1.0, {0.4}, true, true).first, 8U);
    EXPECT_EQ(numbers(1.0, {}, true, true), std::pair(begins, begins));
    EXPECT_EQ(numbers(1.0, {}, false, false), std::pair(begins, begins));
    EXPECT_EQ(numbers(unknown, {}, true, false), std::pair(begins, begins));
}

// The first of a run, and not each that is as long after a measurement as the first one is due after the beginning.

TEST(IncrementSchedule, TakesHalfAsManyWhereFacesMeetAsInLoading) {
    IncrementSchedule schedule{LoadSection()};
    IncrementSchedule::State state = schedule.state();
    state.rising.increments = 15;
    state.falling.increments = 4;
    schedule.resume(state);
    EXPECT_EQ(schedule.ways(false).size(), 5U);
    schedule.meet_at({0.3});
    EXPECT_EQ(schedule.ways(false).size(), 9U);
    state.falling.increments = 10;
    schedule.resume(state);
    schedule.meet_at({0.3});
    EXPECT_EQ(schedule.ways(false).size(), 11U);
    schedule.meet_at({});
    EXPECT_EQ(schedule.ways(false).size(), 11U);
    EXPECT_EQ(schedule.ways(true).size(), 16U);
    state.rising.increments = 18;
    schedule.resume(state);
    schedule.meet_at({0.3}, true);  // into compression
    EXPECT_EQ(schedule.ways(false).size(), 11U);
    state.rising.increments = state.falling.increments = 4;
    schedule.resume(state);
    schedule.meet_at({0.3}, true);
    EXPECT_EQ(schedule.ways(false).size(), 9U);
}

// As where the zone has to grow first.

}  // namespace
}  // namespace stria::coarse
