// The factors of load cases on the way through a history.
#include "coarse/load/case_histories.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "coarse/load/load_controller.hpp"
#include "common/error.hpp"
#include "tests/support/load_cases.hpp"
#include "tests/support/load_stops.hpp"

namespace stria::coarse {
namespace {

// Ends of legs and the turn of what lags by 45 degrees, but not on an ellipse: there only where dead loads have come
// on.
TEST(CaseHistories, LoadsHaveCornersWhereOneOfThemTurns) {
    const auto corners = [](std::vector<LoadCaseSection> load_cases) {
        Case input = cycles(8, {{1, 10.0, -10.0}});
        input.load_cases = std::move(load_cases);
        std::vector<double> at;
        for (LoadController loads = controller(input); loads.next(); loads.accepted())
            if (loads.next()->bends) at.push_back(loads.next()->target.value);
        return at;
    };
    const LoadCaseSection own = test::own_load("own", {{.cycles = 1, .at_max = 1.0, .at_min = 2.0}}),
                          late = test::lagging_load("late", 1.0, 45.0),
                          sharp = test::lagging_load("sharp", 1.0, 45.0, LagPath::Triangle);
    EXPECT_EQ(corners({}), (std::vector<double>{10.0, -10.0, 10.0}));
    EXPECT_EQ(corners({own}), (std::vector<double>{10.0, -10.0, 10.0}));
    EXPECT_EQ(corners({late}), std::vector<double>{});
    EXPECT_EQ(corners({late, test::dead_load("dead", 1.0)}), std::vector<double>{0.0});
    EXPECT_EQ(corners({sharp}), (std::vector<double>{2.5, 10.0, 5.0, -10.0, -5.0, 10.0}));
    EXPECT_EQ(corners({late, own}).size(), 6U);
}

TEST(CaseHistories, ADeadLoadComesFirstAndStays) {
    Case input = cycles(4, {{1, 10.0, -10.0}});
    input.load_cases = {test::dead_load("dead", 3.0)};
    expect_close(stops(controller(input)),
                 {{0, {1.5}}, {0, {3}}, {5, {3}}, {10, {3}}, {0, {3}}, {-10, {3}}, {0, {3}}, {10, {3}}});
    EXPECT_EQ(controller(input).next()->cycle, 0);
}

// A dead load moves the boundary too, so that the main load has less to do, and K is that of both.
TEST(CaseHistories, UnderAControlledDisplacementALegGoesBetweenLoads) {
    Case input = cycles(4, {{1, 10.0, -10.0}});
    input.load.control = Control::Displacement;
    input.load_cases = {test::dead_load("dead", 3.0)};
    UnitDisplacement unit{.mean = 0.5, .largest = 1.0, .of_cases = {0.2}};
    const auto ends_of_legs = [&](LoadController loads) {
        std::vector<Stop> ends;
        for (; loads.next(); loads.accepted())
            if (const std::optional<LegEnds> leg = loads.leg_that_begins(unit))
                for (const LoadFactors& end : {leg->from, leg->to})
                    ends.push_back({end.main, {end.cases.begin(), end.cases.end()}});
        return ends;
    };
    expect_close(
        ends_of_legs(controller(input)),
        {{0.0, {0}}, {0.0, {3}}, {0.0, {3}}, {18.8, {3}}, {18.8, {3}}, {-21.2, {3}}, {-21.2, {3}}, {18.8, {3}}});
    LoadController loads = controller(input);
    EXPECT_EQ(loads.leg_that_begins(unit)->course, 0.0);
    for (int k = 0; k < 4; ++k) loads.accepted();
    EXPECT_EQ(loads.leg_that_begins(unit)->course, -20.0);
    unit.initial = 0.4;
    EXPECT_NEAR(loads.leg_that_begins(unit)->from.main, 18.0, 1e-12);
    EXPECT_NEAR(loads.leg_that_begins(unit)->to.main, -22.0, 1e-12);
}

/// The body under the dead load stands at `there`. With ends of half cycles.
std::vector<std::pair<double, bool>> controlled(const std::vector<LoadBlock>& blocks, double there) {
    Case input = cycles(4, blocks);
    input.load.control = Control::Displacement;
    input.load_cases = {test::dead_load("dead", 3.0)};
    LoadController loads = controller(input);
    std::vector<std::pair<double, bool>> stops;
    while (const std::optional<LoadStep> step = loads.next()) {
        EXPECT_EQ(step->target.control, stops.size() < 2 ? Control::Load : Control::Displacement);
        EXPECT_EQ(loads.reached_target().control, step->target.control);
        stops.emplace_back(step->target.value, step->reversal);
        loads.accepted();
        loads.stands_at(stops.size() < 2 ? 0.5 * there : stops.size() == 2 ? there : step->target.value);
    }
    stops.erase(stops.begin(), stops.begin() + 2);
    return stops;
}

// A controlled displacement goes on from where the dead load has left the boundary, up or down. It turns there or not.
TEST(CaseHistories, TheFirstLegOfADisplacementBeginsWhereADeadLoadHasMovedIt) {
    using Stops = std::vector<std::pair<double, bool>>;
    EXPECT_EQ(controlled({{1, 10.0, -10.0}}, 4.0),
              (Stops{{7, false}, {10, true}, {0, false}, {-10, true}, {0, false}, {10, true}}));
    EXPECT_EQ(controlled({{1, 10.0, -10.0}}, 12.0),
              (Stops{{11, false}, {10, false}, {0, false}, {-10, true}, {0, false}, {10, true}}));
    EXPECT_EQ(controlled({{1, -2.0, -10.0}}, -12.0),
              (Stops{{-7, false}, {-2, true}, {-6, false}, {-10, true}, {-6, false}, {-2, true}}));
    EXPECT_EQ(controlled({{0, 0.0, 0.0}, {0, 10.0, 0.0}}, 4.0), (Stops{{2, false}, {0, true}, {5, false}, {10, true}}));
    EXPECT_EQ(controlled({{0, 0.0, 0.0}}, 4.0), (Stops{{2, false}, {0, true}}));
    EXPECT_EQ(controlled({{1, 10.0, -10.0}}, 10.0 - 1e-12).at(0).first, 10.0) << "what rounding is apart is no way";
}

// So does an initial stress: a first maximum of zero is gone to from there. It was left out, and the boundary went
// straight to the minimum.
TEST(CaseHistories, ADisplacementOfZeroIsGoneToBesideAnInitialStress) {
    const auto extremes = [](const std::vector<LoadBlock>& blocks, bool is_stressed, Control control) {
        Case input = cycles(4, blocks);
        input.load.control = control;
        if (is_stressed) input.regions.emplace_back().initial_stress.emplace();
        std::vector<std::pair<int, double>> ends;
        for (LoadController loads = controller(input); loads.next(); loads.accepted()) {
            const LoadStep step = *loads.next();
            if (step.at_maximum || step.at_minimum) ends.emplace_back(step.cycle, step.target.value);
        }
        return ends;
    };
    using Ends = std::vector<std::pair<int, double>>;
    const std::vector<LoadBlock> down{{1, 0.0, -8.0}}, up{{0, 0.0, 0.0}, {0, 8.0, 0.0}};
    EXPECT_EQ(extremes(down, true, Control::Displacement), (Ends{{0, 0.0}, {1, -8.0}, {1, 0.0}}));
    EXPECT_EQ(extremes(up, true, Control::Displacement), (Ends{{0, 0.0}, {0, 8.0}}));
    EXPECT_EQ(extremes({{0, 0.0, 0.0}}, true, Control::Displacement), (Ends{{0, 0.0}}));
    EXPECT_EQ(extremes({{1, 4.0, -8.0}}, true, Control::Displacement), (Ends{{0, 4.0}, {1, -8.0}, {1, 4.0}}));
    EXPECT_EQ(extremes(down, false, Control::Displacement), (Ends{{1, -8.0}, {1, 0.0}}));
    EXPECT_EQ(extremes(down, true, Control::Load), (Ends{{1, -8.0}, {1, 0.0}})) << "no load is there already";
}

TEST(CaseHistories, HalvingTakesAllLoadsHalfWay) {
    Case input = cycles(2, {{1, 10.0, 0.0}});
    input.load_cases = {test::dead_load("dead", 3.0)};
    LoadController loads = controller(input);
    ASSERT_TRUE(loads.cut());
    EXPECT_EQ(loads.next()->target.cases[0], 1.5);
    EXPECT_EQ(loads.next()->target.value, 0.0);
    loads.accepted();
    EXPECT_EQ(loads.reached_target().cases[0], 1.5);
    EXPECT_EQ(loads.next()->target.cases[0], 3.0);
    EXPECT_EQ(loads.next()->predictor, 1.0);
}

TEST(CaseHistories, WarnOfAPressureThatLeapsOverACrack) {
    Case input = cycles(64, {{2, 0.0, -1.0}});
    EXPECT_TRUE(travel_warnings(input).empty());
    input.boundaries = {test::under_wheel("top", {.p0 = 1.0, .half_width = 1.0, .from = -8.0, .to = 8.0})};
    EXPECT_TRUE(travel_warnings(input).empty());
    input.load.steps = 32;
    EXPECT_TRUE(travel_warnings(input).empty());
    input.load.steps = 30;
    EXPECT_NE(travel_warnings(input).at(0).find("load.steps = 30: "), std::string::npos);
    EXPECT_NE(travel_warnings(input).at(0).find("takes 64"), std::string::npos);
}

TEST(CaseHistories, ALoadMayHaveExtremesOfItsOwn) {
    Case input = cycles(4, {{1, 10.0, 0.0}, {2, 20.0, -20.0}});
    input.load.repeat = 2;
    input.load_cases = {test::own_load("own", {{1, 1.0, 2.0}, {1, 3.0, 4.0}, {1, 5.0, 6.0}})};
    std::vector<double> at_turns;
    const std::vector<Stop> all = stops(controller(input));
    for (std::size_t k = 1; k < all.size(); k += 2) at_turns.push_back(all[k].cases[0]);
    EXPECT_EQ(at_turns, (std::vector<double>{1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 6, 5}));
    EXPECT_EQ(all[2].cases[0], 1.5);
}

// The last leg of a history rises to a factor of its own cycle, in a longer one to that of the next.
TEST(CaseHistories, AHistoryGoesOnWhereItsLoadCasesStand) {
    Case input = cycles(4, {{2, 10.0, 0.0}});
    const auto goes_on = [&](const std::vector<CaseBlock>& blocks) {
        input.load_cases = {test::own_load("own", blocks)};
        LoadController brief = controller(input);
        while (brief.next()) brief.accepted();
        Case longer = input;
        longer.load.repeat = 2;
        controller(longer).resume(brief.position());
    };
    EXPECT_NO_THROW(goes_on({{2, 1.0, 2.0}}));
    EXPECT_THROW(goes_on({{1, 1.0, 2.0}, {1, 3.0, 2.0}}), CaseError);
}

// It comes on at its first position, goes through all of them in each cycle, and leaps from the last to the second.
TEST(CaseHistories, APressureTravelsOncePerCycle) {
    Case input = cycles(4, {{2, 0.0, -1.0}});
    input.boundaries = {test::under_wheel("top", {.p0 = 1.0, .half_width = 1.0, .to = 8.0})};
    EXPECT_EQ(CaseHistories(input).count(), 5);
    const auto at = [](int position, double factor = 1.0) {
        std::vector<double> factors(5, 0.0);
        factors[static_cast<std::size_t>(position)] = factor;
        return factors;
    };
    expect_close(stops(controller(input)), {{0, at(0, 0.5)},
                                            {0, at(0)},
                                            {-0.5, at(1)},
                                            {-1, at(2)},
                                            {-0.5, at(3)},
                                            {0, at(4)},
                                            {-0.5, at(1)},
                                            {-1, at(2)},
                                            {-0.5, at(3)},
                                            {0, at(4)}});
    LoadController loads = controller(input);
    for (int k = 0; k < 6; ++k) loads.accepted();
    ASSERT_TRUE(loads.cut());
    const Eigen::VectorXd between = loads.next()->target.cases;
    EXPECT_EQ(between[4], 0.5);
    EXPECT_EQ(between[1], 0.5);
    EXPECT_EQ(between.sum(), 1.0);
}

TEST(CaseHistories, TheLargestSumIsNoLessThanAnyOfTheHistory) {
    Case input = cycles(8, {{2, 10.0, -4.0}});
    input.load_cases = {test::dead_load("dead", 3.0), test::lagging_load("late", -1.0, 70.0),
                        test::own_load("own", {{2, 1.0, -2.0}})};
    const CaseHistories cases(input);
    const std::vector<double> unit{2.0, 1.0, -4.0};
    EXPECT_EQ(cases.largest_sum(unit, 1.0), 6.0 + 4.0 + 8.0);
    for (const Stop& stop : stops(controller(input))) {
        double sum = 0.0;
        for (std::size_t k = 0; k < 3; ++k) sum += unit[k] * stop.cases[k];
        EXPECT_LE(sum, 18.0);
    }
}

// It was left out of the sum: the default of closure.distance was 2.6 times as large as beside the same load with K up
// to as much.
TEST(CaseHistories, ADeadLoadTakesFromTheLargestSum) {
    Case input = cycles(2, {{2, 3.0, 1.0}});
    input.load_cases = {test::dead_load("dead", -6.0), test::lagging_load("late", 2.0, 90.0)};
    EXPECT_EQ(CaseHistories(input).largest_sum({2.0, 4.0}, 1.0), -12.0 + 24.0);
    EXPECT_EQ(CaseHistories(input).largest_sum({-2.0, -4.0}, 1.0), 12.0);  // what lags begins from nothing
}

// Near its maximum [load] hardly changes while what lags by a quarter of a cycle does.
TEST(CaseHistories, TheLoadThatChangesMostTellsHowLargeAnIncrementIs) {
    Case input = cycles(4, {{2, 10.0, -10.0}});
    input.load.grading.reset();
    input.load_cases = {test::lagging_load("late", 3.0, 90.0), test::dead_load("dead", 50.0)};
    LoadController loads = controller(input);
    while (loads.next()->cycle == 0) loads.accepted();
    EXPECT_NEAR(loads.part_of_loads(), 1.0, 1e-12);  // from 10 to 0, and from 0 to 30
    for (int steps : {24, 96}) {
        input.load.steps = steps;
        loads = controller(input);
        while (loads.next()->cycle < 2) loads.accepted();
        const double angle = 2.0 * std::numbers::pi / steps;
        EXPECT_NEAR(loads.part_of_loads(), std::sin(angle), 1e-12);
        EXPECT_LT(10.0 - loads.next()->target.value, 5.0 * angle * angle);
    }
}

TEST(CaseHistories, SoDoesOneWithExtremesOfItsOwn) {
    LoadController alone(cycles(4, {{1, 10.0, -10.0}}).load, {});
    alone.accepted();
    alone.accepted();
    alone.accepted();
    EXPECT_EQ(alone.part_of_loads(), 1.0);  // 10 to 0 of 10
    Case input = cycles(40, {{1, 10.0, 9.9}});
    input.load_cases.emplace_back().blocks = {{.cycles = 1, .at_max = 40.0, .at_min = -20.0}};
    LoadController loads = controller(input);
    while (loads.next()->cycle == 0) loads.accepted();
    EXPECT_NEAR(loads.part_of_loads(), 3.0 / 40.0, 1e-12);
}

}  // namespace
}  // namespace stria::coarse
