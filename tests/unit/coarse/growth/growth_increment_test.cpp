// Increments of growth that the program chooses.
#include "coarse/growth/growth_increment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "coarse/growth/growth_law.hpp"

namespace stria::coarse {
namespace {

const GrowthSection by_K_eff{.law = GrowthLaw::Paris,
                             .increment = {},
                             .accuracy = 0.01,
                             .zone_fraction = 0.25,
                             .C = 1e-12,
                             .m = 3.0,
                             .driving = GrowthDriving::EffectiveRange};

constexpr TipSteps steps{.least = 0.1 / 16.0};  // mm

/// A tip at K = 300 sqrt(a / 10) in a zone of 0.4 mm straight ahead, 1.6 mm to the sides.
CycleResult tip_at(double a, double closure) {
    CycleResult tip;
    tip.a = a;
    tip.K_max = 300.0 * std::sqrt(a / 10.0);
    tip.K_min = 0.0;
    tip.opening.K_op = closure * tip.K_max;
    tip.forward = 1.6;
    tip.forward_axis = 0.4;
    return tip;
}

double next(GrowthIncrement& increment, const GrowthSection& growth, const std::vector<CycleResult>& last,
            const TipSteps& by = steps) {
    increment.add(last);
    const std::vector<double> rates = growth_rates(growth, last);
    return increment.next(growth, last, rates, shares_of_advance(growth, rates, last.size()), by);
}

double first(GrowthIncrement increment, const GrowthSection& growth, const std::vector<CycleResult>& last,
             const TipSteps& by) {
    return next(increment, growth, last, by);
}

struct Life {
    double cycles = 0.0;
    std::vector<double> increments;
};

/// From 10 mm to 12.
Life live(GrowthSection growth, const std::function<double(double)>& closure) {
    growth.until = 12.0;
    GrowthIncrement increment;
    Life life;
    std::vector<CycleResult> last{tip_at(10.0, closure(10.0))};
    while (last[0].a < 12.0 - 1e-9) {
        const double size = life.increments.emplace_back(next(increment, growth, last, steps));
        const std::vector<CycleResult> now{tip_at(last[0].a + size, closure(last[0].a + size))};
        life.cycles +=
            cycles_passed(size, fastest_rate(growth_rates(growth, last)), fastest_rate(growth_rates(growth, now)));
        last = now;
    }
    return life;
}

TEST(GrowthIncrement, BeginsSmallAndDoublesUpToAFractionOfTheZone) {
    const Life life = live(by_K_eff, [](double) { return 0.3; });
    EXPECT_NEAR(life.increments[0], steps.least, 1e-15);
    for (std::size_t k = 1; k < 5; ++k) EXPECT_NEAR(life.increments[k], 2.0 * life.increments[k - 1], 1e-14);
    EXPECT_NEAR(life.increments[5], 0.1, 1e-14);
}

TEST(GrowthIncrement, EndsWhereGrowthEnds) {
    const Life life = live(by_K_eff, [](double) { return 0.3; });
    EXPECT_LT(life.increments.back(), 0.1);
    double grown = 0.0;
    for (const double size : life.increments) grown += size;
    EXPECT_NEAR(grown, 2.0, 1e-12);
}

// Closure that builds up within a few tenths of a millimetre: small increments there, and the life to the accuracy.
TEST(GrowthIncrement, KeepsTheLifeToItsAccuracy) {
    const auto closure = [](double a) { return 0.4 * (1.0 - std::exp(-(a - 10.0) / 0.2)); };
    double exact = 0.0;
    constexpr int parts = 200'000;
    for (int k = 0; k < parts; ++k) {
        const double a = 10.0 + 2.0 * (k + 0.5) / parts;
        exact += 2.0 / parts / growth_rate(by_K_eff, tip_at(a, closure(a)));
    }
    GrowthSection loose = by_K_eff;
    loose.accuracy = 0.5;
    loose.zone_fraction = 1.0;
    GrowthSection tight = loose;
    tight.accuracy = 0.01;
    const auto error = [&](const Life& life) { return std::abs(life.cycles / exact - 1.0); };
    EXPECT_LT(error(live(tight, closure)), 0.01);
    EXPECT_GT(error(live(loose, closure)), 2.0 * error(live(tight, closure)));
    EXPECT_LT(live(loose, closure).increments.size(), live(tight, closure).increments.size());
}

// Half of the distance from the chord, of what a millimetre takes: errors fall with the square of the increment.
TEST(GrowthIncrement, GoesByTheRootOfWhatTheLastWasOffBy) {
    const CycleResult now = tip_at(10.0, 0.1);
    const double per_mm = 1.0 / growth_rate(by_K_eff, now);
    for (const double error : {0.005, 0.02}) {
        GrowthIncrement increment({.increment = 0.04,
                                   .points = {{.a = 9.8, .per_mm = per_mm, .closure = 0.1},
                                              {.a = 9.9, .per_mm = (1.0 + 2.0 * error) * per_mm, .closure = 0.1}}});
        EXPECT_NEAR(next(increment, by_K_eff, {now}), 0.04 * std::sqrt(by_K_eff.accuracy / error), 1e-12) << error;
    }
}

TEST(GrowthIncrement, IsHalvedWhereClosureJumps) {
    const Life life = live(by_K_eff, [](double a) { return a < 11.0 ? 0.1 : 0.4; });
    double a = 10.0;
    std::size_t k = 0;
    while (a < 11.0) a += life.increments[k++];
    EXPECT_NEAR(life.increments[k], 0.05, 1e-14);  // the first that knows of it
}

TEST(GrowthIncrement, IsNoSmallerThanAnElement) {
    GrowthIncrement increment({.increment = 0.1, .points = {{.a = 9.9, .per_mm = 1.0, .closure = 0.9}}});
    EXPECT_EQ(next(increment, by_K_eff, {tip_at(10.0, 0.1)}, {.least = 0.3}),
              0.3);  // though a quarter of the zone is less
}

// The tip begins 0.03 mm beyond the edge on which its faces end.
TEST(GrowthIncrement, GoesFromOneElementEdgeToAnother) {
    constexpr double edge = 0.07;
    const auto next_from = [&](double last, double beyond) {
        return first(GrowthIncrement({.increment = last, .points = {}}), by_K_eff, {tip_at(10.0, 0.3)},
                     {.least = edge, .element = edge, .beyond = beyond});
    };
    EXPECT_NEAR(next_from(0.0, 0.03), 0.04, 1e-14);
    EXPECT_NEAR(next_from(0.0, 0.0), 0.07, 1e-14);
    EXPECT_NEAR(next_from(0.09, 0.0), 0.07, 1e-14);  // a quarter of the zone is 0.1: no second element fits
    EXPECT_NEAR(next_from(0.0, 0.07), 0.07, 1e-14) << "half way into an element twice as large";
    EXPECT_NEAR(next_from(0.0, 0.08), 0.06, 1e-14);
}

// A crest at the end of two elements would hold the faces: it matters where they drive the growth.
TEST(GrowthIncrement, TakesOneElementWhereOpeningsDriveIt) {
    constexpr double edge = 0.07;
    const auto next_by = [](GrowthSection growth, const TipSteps& by) {
        growth.zone_fraction = 0.5;
        GrowthIncrement increment({.increment = 0.09, .points = {}});
        increment.add({tip_at(10.0, 0.3)});
        return increment.next(growth, {tip_at(10.0, 0.3)}, {0.01}, {1.0}, by);
    };
    constexpr TipSteps edges{.least = edge, .element = edge, .beyond = -0.02};
    GrowthSection by_range = by_K_eff, by_opening = by_K_eff;
    by_range.driving = GrowthDriving::Range;
    by_opening.law = GrowthLaw::Ctod;
    EXPECT_NEAR(next_by(by_K_eff, edges), 0.09, 1e-14);
    EXPECT_NEAR(next_by(by_opening, edges), 0.09, 1e-14);
    EXPECT_NEAR(next_by(by_range, edges), 0.16, 1e-14);
    EXPECT_NEAR(next_by(by_K_eff, {.least = edge}), 0.18, 1e-14) << "faces end anywhere";
}

TEST(GrowthIncrement, NoTipPassesUntil) {
    GrowthSection growth = by_K_eff;
    growth.until = 10.05;
    constexpr TipSteps far{.least = 0.3};
    EXPECT_NEAR(first(GrowthIncrement(), growth, {tip_at(10.0, 0.1)}, far), 0.05, 1e-14);
    const std::vector<CycleResult> both{tip_at(9.0, 0.1), tip_at(10.0, 0.4)};  // the slower one is there first
    const double ratio = growth_rate(growth, both[0]) / growth_rate(growth, both[1]);
    ASSERT_GT(ratio, 1.0);
    EXPECT_NEAR(first(GrowthIncrement(), growth, both, far), 0.05 * ratio, 1e-14);
    // Half of a crack whose other tip stands still grows half as fast.
    const std::vector<CycleResult> ends{tip_at(10.0, 0.1), tip_at(10.0, 0.4)};
    EXPECT_NEAR(GrowthIncrement().next(growth, ends, {0.01, 0.0}, {0.5, 0.5}, far), 0.1, 1e-14);
}

TEST(GrowthIncrement, WithoutFlowGoesByTheCrackLength) {
    CycleResult tip = tip_at(10.0, 0.0);
    tip.forward = tip.forward_axis = 0.0;
    tip.opening.K_op = std::nan("");
    GrowthSection growth = by_K_eff;
    growth.driving = GrowthDriving::Range;
    EXPECT_NEAR(first(GrowthIncrement({.increment = 1.0, .points = {}}), growth, {tip}, steps), 0.1, 1e-15);
}

// Where cracks do not grow in each cycle the metal shakes down: the zone is that of the cycle with the growth.
TEST(GrowthIncrement, GoesByTheZoneSinceTheLastGrowth) {
    CycleResult grown = tip_at(10.0, 0.1), shaken_down = grown;
    grown.da = 0.1;
    shaken_down.forward = shaken_down.forward_axis = 0.0;
    GrowthIncrement increment({.increment = 1.0, .points = {}});
    increment.add({shaken_down});
    increment.add({grown});
    increment.add({shaken_down});
    EXPECT_NEAR(next(increment, by_K_eff, {shaken_down}), 0.25 * 0.4, 1e-15);
    grown.forward_axis = 0.2;
    EXPECT_NEAR(next(increment, by_K_eff, {grown}), 0.25 * 0.2, 1e-15) << "of another growth";
}

// Metal flows, and to the sides alone.
TEST(GrowthIncrement, TakesTheLeastWhereNothingFlowsAhead) {
    CycleResult tip = tip_at(10.0, 0.1);
    tip.forward_axis = 0.0;
    EXPECT_EQ(first(GrowthIncrement({.increment = 1.0, .points = {}}), by_K_eff, {tip}, steps), steps.least);
}

TEST(GrowthIncrement, GoesOnFromItsMemory) {
    const std::vector<CycleResult> one{tip_at(10.0, 0.1)}, two{tip_at(10.01, 0.1)}, three{tip_at(10.02, 0.3)};
    GrowthIncrement whole;
    next(whole, by_K_eff, one);
    next(whole, by_K_eff, two);
    GrowthIncrement resumed(whole.memory());
    EXPECT_EQ(next(whole, by_K_eff, three), next(resumed, by_K_eff, three));
}

// K goes with a power of the length: with its root, unless the growth before says otherwise.
TEST(GrowthIncrement, EndsWhereKReachesTheToughness) {
    const double toughness = 330.0, cut = 10.0 * (std::pow(1.001 * 1.1, 2.0) - 1.0);
    EXPECT_NEAR(cut_to_toughness(5.0, toughness, {{10.0, 300.0}}, {}, {1.0}), cut, 1e-12);
    EXPECT_NEAR(cut_to_toughness(5.0, toughness, {{10.0, 300.0}}, {}, {0.5}), 2.0 * cut, 1e-12);
    EXPECT_EQ(cut_to_toughness(0.5, toughness, {{10.0, 300.0}}, {}, {1.0}), 0.5);
    const LengthAndK before{8.0, 300.0 * std::pow(0.8, 1.5)};
    EXPECT_NEAR(cut_to_toughness(5.0, toughness, {{10.0, 300.0}}, {before}, {1.0}),
                10.0 * (std::pow(1.001 * 1.1, 1.0 / 1.5) - 1.0), 1e-12);
    EXPECT_NEAR(cut_to_toughness(5.0, toughness, {{10.0, 300.0}}, {{9.9, 200.0}}, {1.0}),
                10.0 * (std::pow(1.001 * 1.1, 0.2) - 1.0), 1e-12);
    EXPECT_EQ(cut_to_toughness(0.5, toughness, {{10.0, 300.0}, {5.0, 329.0}}, {}, {1.0, 0.0}), 0.5);
    EXPECT_NEAR(cut_to_toughness(5.0, toughness, {{10.0, 300.0}, {10.0, 329.0}}, {}, {1.0, 1.0}),
                10.0 * (std::pow(1.001 * 330.0 / 329.0, 2.0) - 1.0), 1e-12);
    EXPECT_EQ(cut_to_toughness(5.0, toughness, {{10.0, 330.3}}, {}, {1.0}), 0.05);
}

}  // namespace
}  // namespace stria::coarse
