// The factors of load cases that lag behind the load.
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

TEST(CaseHistories, InPhaseALoadIsInProportion) {
    Case input = cycles(8, {{2, 10.0, -4.0}, {1, 20.0, 0.0}});
    input.load_cases = {test::lagging_load("more", 0.5)};
    for (const Stop& stop : stops(controller(input))) EXPECT_NEAR(stop.cases[0], 0.5 * stop.main, 1e-12);
}

// Behind by a quarter of a cycle the two run through an ellipse about their means, and its vertices are stops.
TEST(CaseHistories, OutOfPhaseItRunsThroughAnEllipse) {
    Case input = cycles(16, {{3, 10.0, -6.0}});
    input.load.grading = 0.6;
    input.load_cases = {test::lagging_load("shear", 2.0, 90.0)};
    const std::vector<Stop> all = stops(controller(input));
    double most = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k) {
        most = std::max(most, all[k].cases[0]);
        const double x = (all[k].main - 2.0) / 8.0, y = (0.5 * all[k].cases[0] - 2.0) / 8.0;
        if (k < 24) continue;  // the ramp lasts until its lag has passed
        EXPECT_NEAR(x * x + y * y, 1.0, 1e-12) << k;
    }
    EXPECT_NEAR(most, 20.0, 1e-12);
    EXPECT_NEAR(all.back().cases[0], 4.0, 1e-12);  // the mean, on its way up
}

// Chords of an ellipse, all of the same angle: the polygon of n corners encloses the most.
TEST(CaseHistories, OutOfPhaseIncrementsTakeEqualAngles) {
    constexpr int n = 16;
    Case input = cycles(n, {{2, 10.0, -10.0}});
    input.load.grading.reset();
    input.load_cases = {test::lagging_load("shear", 1.0, 90.0)};
    const std::vector<Stop> all = stops(controller(input));
    double area = 0.0;
    for (std::size_t k = all.size() - n; k < all.size(); ++k)
        area += 0.5 * std::abs(all[k - 1].main * all[k].cases[0] - all[k].main * all[k - 1].cases[0]);
    EXPECT_NEAR(area, 100.0 * 0.5 * n * std::sin(2.0 * std::numbers::pi / n), 1e-9);
    input.load_cases[0].path = LagPath::Triangle;
    for (const double way : CaseHistories(input).at_equal_angles(4)) EXPECT_EQ(std::fmod(way, 0.25), 0.0) << way;
}

TEST(CaseHistories, TellTheNextQuarterWhereALoadLags) {
    Case input = cycles(8, {{2, 10.0, -10.0}});
    EXPECT_FALSE(controller(input).looks_ahead());
    EXPECT_TRUE(controller(input).next_quarter().empty());
    input.load_cases = {test::lagging_load("shear", 2.0, 90.0)};
    LoadController loads = controller(input);
    while (!loads.next()->ends_cycle) loads.accepted();  // the ellipse begins behind the ramp
    const std::vector<LoadFactors> quarter = loads.next_quarter();
    ASSERT_EQ(quarter.size(), 66);
    EXPECT_NEAR(quarter.front().main, 10.0, 1e-12);
    EXPECT_NEAR(quarter[64].main, 0.0, 1e-12);
    for (const LoadFactors& at : quarter) EXPECT_LE(std::hypot(at.main, at.of_case(0) / 2.0), 10.0 * (1.0 + 1e-12));
    EXPECT_NEAR(quarter[64].of_case(0), 20.0, 1e-12);
    EXPECT_LT(quarter.back().of_case(0), quarter[64].of_case(0)) << "it was not seen to turn";
    input.load.control = Control::Displacement;
    EXPECT_TRUE(controller(input).next_quarter().empty());
}

// The peak of a triangle was missed by up to 0.4 % of its range.
TEST(CaseHistories, TheNextQuarterHasTheTurnsWithinIt) {
    Case input = cycles(8, {{2, 10.0, -10.0}});
    for (const double phase : {1.0, 30.0, 89.0, 90.0}) {
        input.load_cases = {test::lagging_load("late", 2.0, phase, LagPath::Triangle)};
        LoadController loads = controller(input);
        while (!loads.next()->ends_cycle) loads.accepted();
        double most = 0.0;
        for (const LoadFactors& at : loads.next_quarter()) most = std::max(most, at.of_case(0));
        EXPECT_NEAR(most, 20.0, 1e-12) << phase;
    }
}

// Where the next cycle is like this one, that is what comes.
TEST(CaseHistories, TurnBackAsInEqualCycles) {
    for (const LagPath path : {LagPath::Sine, LagPath::Triangle})
        for (const double phase : {30.0, 90.0, 200.0, 300.0}) {
            Case input = cycles(8, {{3, 10.0, -4.0}});
            input.load_cases = {test::lagging_load("late", 2.0, phase, path), test::dead_load("dead", 3.0),
                                test::own_load("own", {{1, 2.0, -5.0}}), test::lagging_load("beside", 0.5)};
            const CaseHistories histories(input);
            constexpr std::size_t at_end = 5;  // behind the dead load, the ramp and three legs
            ASSERT_TRUE(histories.legs()[at_end].ends_cycle);
            for (const double way : {0.0, 0.1, 0.3, 0.5, 0.9}) {
                const LoadFactors found = histories.turning_back(at_end, way, 1.0);
                EXPECT_NEAR(found.main, 10.0 - 14.0 * way, 1e-12);
                EXPECT_LT((found.cases - histories.at({.leg = at_end + 1, .way = way})).norm(), 1e-12) << phase;
            }
        }
}

TEST(CaseHistories, StraightPathsMakeARhombus) {
    Case input = cycles(8, {{2, 1.0, -1.0}});
    input.load_cases = {test::lagging_load("shear", 1.0, 90.0, LagPath::Triangle)};
    const std::vector<Stop> all = stops(controller(input));
    for (std::size_t k = 8; k < all.size(); ++k)
        EXPECT_NEAR(std::abs(all[k].main) + std::abs(all[k].cases[0]), 1.0, 1e-12) << k;
}

TEST(CaseHistories, ALagIsContinuousWhereTheCyclesChange) {
    Case input = cycles(400, {{1, 10.0, 0.0}, {1, 30.0, -10.0}, {2, 5.0, 0.0}});
    input.load_cases = {test::lagging_load("late", 1.0, 120.0)};
    double before = 0.0;
    for (const Stop& stop : stops(controller(input))) {
        EXPECT_LT(std::abs(stop.cases[0] - before), 3.0);  // a 200th of [load] is 8 degrees where it turns
        before = stop.cases[0];
    }
}

}  // namespace
}  // namespace stria::coarse
