// Increments that the program chooses: how far those of a leg are off, when that is measured, and how many there are
// then.
#include "coarse/load/increment_schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "coarse/load/load_controller.hpp"
#include "tests/support/measured_legs.hpp"

namespace stria::coarse {
namespace {

TEST(IncrementSchedule, KnowsHowFarALegIsOff) {
    for (const double c : {0.01, -0.3})
        for (const int increments : {4, 6, 12}) {
            const OffByTheSquare leg{graded_ways(increments, 0.4), c};
            double off = 0.0;
            for (std::size_t k = 1; k < leg.ways.size(); ++k) off += std::abs(leg.off(k));
            const OpeningPath path = leg.path();
            EXPECT_NEAR(*error_of_leg(path, leg.pairs()), off / std::abs(path.opening.back()[0] - 1.0), 1e-9);
        }
}

TEST(IncrementSchedule, HearsTheTipThatIsFarthestOff) {
    OpeningPath path;
    path.begin({1.0, 3.0});
    for (const double w : {0.5, 1.0}) path.add(w, {1.0 + w, 3.0 - 2.0 * w});
    const auto error = [&](double first, double second) { return error_of_leg(path, {{0.0, 1.0, {first, second}}}); };
    EXPECT_NEAR(*error(2.01, 1.01), 0.01, 1e-12) << "of a range of 1; the other has one of 2";
    EXPECT_NEAR(*error(2.0, 0.9), 0.05, 1e-12);
    EXPECT_NEAR(*error(std::numeric_limits<double>::quiet_NaN(), 0.9), 0.05, 1e-12) << "the first tip is elastic";
    EXPECT_FALSE(error_of_leg(path, {{0.0, 0.5, {1.5, 2.0}}})) << "one increment, and no two";
    EXPECT_FALSE(error_of_leg(path, {{0.25, 1.0, {2.0, 1.0}}})) << "increments that were halved";
    for (std::vector<double>& opening : path.opening) opening[0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NEAR(*error(2.0, 0.9), 0.05, 1e-12);
    EXPECT_FALSE(error_of_leg(OpeningPath(), {}));
}

TEST(IncrementSchedule, GradesWaysAndKeepsTurns) {
    EXPECT_EQ(graded_ways(4, 1.0), (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
    EXPECT_EQ(through_turns(graded_ways(4, 1.0), {0.6}), (std::vector<double>{0.0, 0.25, 0.6, 0.75, 1.0}));
    EXPECT_DOUBLE_EQ(graded_ways(2, 0.4)[1], std::pow(0.5, 0.4));
}

// An error that falls with the square of the number comes below a third of the accuracy.
TEST(IncrementSchedule, TakesAsManyAsTheErrorAsksFor) {
    const int begins = LoadSection().first_steps() / 2;
    const OffByTheSquare leg{graded_ways(begins, 0.4), 0.03};
    const OpeningPath path = leg.path();
    const double error = *error_of_leg(path, leg.pairs());
    for (const double accuracy : {0.01, 0.002}) {
        const int chosen = after({.accuracy = accuracy, .blocks = {}}, leg.c);
        EXPECT_LE(error * std::pow(1.0 * begins / chosen, 2), accuracy / 3.0);
        EXPECT_GT(error * std::pow(1.0 * begins / (chosen - 1), 2), accuracy / 3.0);
    }
    // What faces that are pressed together leave behind adds up.
    const int pressed = after({.accuracy = 0.01, .blocks = {}}, leg.c, true);
    EXPECT_LE(error * std::pow(1.0 * begins / pressed, 2), 0.01 / 6.0);
    EXPECT_GT(error * std::pow(1.0 * begins / (pressed - 1), 2), 0.01 / 6.0);
    EXPECT_EQ(after({.accuracy = 1e-9, .blocks = {}}, 0.05), 96);
    EXPECT_EQ(after({.accuracy = 1e-9, .blocks = {}}, 0.05, true), 160);
    EXPECT_EQ(after({}, 10.0), 24);
    EXPECT_EQ(after({}, 10.0, true), 40);
    EXPECT_EQ(after({}, 1e-9), 4);
}

TEST(IncrementSchedule, HasManyInTheFirstLegAlone) {
    IncrementSchedule schedule{LoadSection()};
    const auto steps = [&] {
        schedule.begin({1.0});
        schedule.meet_at({}, true);
        return schedule.ways(false).size() - 1;
    };
    EXPECT_EQ(steps(), 20U);
    IncrementSchedule::State later = schedule.state();
    later.falling.taken = true;
    schedule.resume(later);
    EXPECT_EQ(steps(), LoadSection().first_steps() / 2);
}

// With as many as there may be.
TEST(IncrementSchedule, SaysWhatItMisses) {
    const auto missed = [](double off) {
        IncrementSchedule schedule{LoadSection()};
        IncrementSchedule::State state = schedule.state();
        state.rising.unmeasured = 32;
        schedule.resume(state);
        const OffByTheSquare leg{schedule.ways(true), off};
        const OpeningPath path = leg.path();
        schedule.begin(std::vector<double>(path.opening.front()));
        for (const TwoAsOne& pair : leg.pairs()) schedule.add(pair);
        for (std::size_t k = 1; k < leg.ways.size(); ++k) schedule.add(leg.ways[k], path.opening[k]);
        schedule.end_leg(true, false);
        EXPECT_EQ(schedule.ways(true).size() - 1, 24U);
        const double taken = static_cast<double>(leg.ways.size()) - 1.0;
        const double left = *error_of_leg(path, leg.pairs()) * std::pow(taken / 24.0, 2);
        const std::optional<double> miss = schedule.take_miss();
        EXPECT_NEAR(miss.value_or(left), left, 1e-12);
        EXPECT_FALSE(schedule.take_miss().has_value()) << "told once";
        return miss.has_value();
    };
    EXPECT_FALSE(missed(0.04));  // more than a third of the accuracy, and less than half of it
    EXPECT_TRUE(missed(0.3));
}

TEST(IncrementSchedule, ChoosesNoneWhereWaysAreGiven) {
    IncrementSchedule schedule(LoadSection(), {0.0, 0.3, 1.0});
    schedule.begin({0.0});
    for (int legs = 0; legs < 40; ++legs) EXPECT_FALSE(schedule.measures(legs % 2 == 0, true));
    schedule.meet_at({0.7});
    for (const bool rises : {true, false}) EXPECT_EQ(schedule.ways(rises), (std::vector<double>{0.0, 0.3, 1.0}));
}
TEST(IncrementSchedule, TakesTheLastTrialOfAPlace) {
    const LoadSection load{.accuracy = 0.01, .blocks = {}};
    EXPECT_EQ(after(load, 0.03, false, true), after(load, 0.03));
}

TEST(IncrementSchedule, LeavesGivenNumbersAlone) {
    const int begins = LoadSection().first_steps() / 2;
    EXPECT_GT(after({}, 0.05), begins);
    EXPECT_EQ(after({.steps = 16, .blocks = {}}, 0.05), 8);
    EXPECT_EQ(after({}, std::numeric_limits<double>::quiet_NaN()), begins);
}

// The fourth leg of a block, and one in many: what changes from leg to leg is measured as often.
TEST(IncrementSchedule, MeasuresNowAndThen) {
    const auto measured = [](const std::function<bool(int)>& alike) {
        IncrementSchedule schedule{LoadSection()};
        std::vector<int> legs;
        for (int leg = 1; leg <= 100; ++leg) {
            schedule.begin({0.0});
            if (schedule.measures(true, alike(leg))) {
                legs.push_back(leg);
                for (const double from : {0.0, 0.3, 0.6}) schedule.add(TwoAsOne{from, 1.0, {1.0}});
            }
            schedule.add(1.0, {1.0});
            schedule.end_leg(true, alike(leg));
        }
        return legs;
    };
    EXPECT_EQ(measured([](int leg) { return leg > 1; }), (std::vector<int>{4, 37, 70}));
    EXPECT_EQ(measured([](int leg) { return leg != 1 && leg != 25 && leg != 26; }), (std::vector<int>{4, 29, 62, 95}))
        << "an overload";
    EXPECT_EQ(measured([](int leg) { return leg % 10 > 1; }), (std::vector<int>{4, 24, 44, 64, 84})) << "and many";
    EXPECT_EQ(measured([](int) { return false; }), (std::vector<int>{20, 53, 86})) << "a spectrum";
    IncrementSchedule ramp{LoadSection()};
    ramp.add(1.0, {1.0});
    EXPECT_FALSE(ramp.measures(true, true)) << "a leg whose start nobody has seen";
}

// A crack that is shorter than the distance at which openings are looked at grows beyond it.
TEST(IncrementSchedule, MeasuresOnceAnOpeningIsKnown) {
    IncrementSchedule schedule(LoadSection{});
    const auto measures_after_leg = [&](double opening) {
        const std::vector<double> ways = schedule.ways(true);
        schedule.begin({opening});
        const bool measures = schedule.measures(true, true);
        for (std::size_t k = 1; k < ways.size(); ++k) schedule.add(ways[k], {opening + ways[k]});
        schedule.end_leg(true, true);
        return measures;
    };
    for (int legs = 0; legs < 10; ++legs)
        EXPECT_FALSE(measures_after_leg(std::numeric_limits<double>::quiet_NaN())) << legs;
    bool measures = false;
    for (int legs = 0; legs < 4; ++legs) measures = measures || measures_after_leg(1.0);
    EXPECT_TRUE(measures) << "as of a crack that has been long enough from the beginning";
}

// Extremes stay exact, each leg keeps its number until it is measured again, and a run that is gone on with has learned
// what the first one had.
TEST(IncrementSchedule, GuidesTheController) {
    const LoadSection load{.blocks = {{.cycles = 5, .max = 50.0 / 3.0, .min = 0.1}}};
    LoadController loads(load, {});
    std::vector<int> per_leg(1, 0);
    std::optional<LoadController> again;
    const auto opening = [](const LoadStep& step) { return std::vector<double>{step.target.value}; };
    int as_one = 0;
    while (const auto step = loads.next()) {
        if (again) {
            EXPECT_EQ(again->next()->target.value, step->target.value);
        }
        if (const auto two = loads.two_as_one()) {
            ++as_one;
            const double off = 0.5 * (two->target.value - step->target.value);
            loads.tried_as_one({two->target.value + off});
            if (again) again->tried_as_one({two->target.value + off});
            if (per_leg.back() == 4) {
                EXPECT_TRUE(two->target.value == 50.0 / 3.0 || two->target.value == 0.1);
            }
        }
        loads.accepted(opening(*step));
        if (again) again->accepted(opening(*step));
        ++per_leg.back();
        if (!step->reversal) continue;
        EXPECT_TRUE(step->target.value == 50.0 / 3.0 || step->target.value == 0.1);
        per_leg.push_back(0);
        if (per_leg.size() == 8) {
            again.emplace(load, SolverSection());
            again->resume(loads.position());
        }
    }
    const int begins = load.first_steps() / 2;
    EXPECT_EQ(std::vector<int>(per_leg.begin(), per_leg.begin() + 9), std::vector<int>(9, begins))
        << "the ramp is no cycle, and the fourth one is measured";
    EXPECT_EQ(as_one, 2 * begins / 2);
    EXPECT_GT(per_leg[9], begins);
    EXPECT_GT(per_leg[10], begins);
}

}  // namespace
}  // namespace stria::coarse
