#include "coarse/growth/crack_advance.hpp"
#include "coarse/growth/growth_law.hpp"
#include "coarse/load/growth_schedule.hpp"
#include "common/case/case_questions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria::coarse {
namespace {

CycleResult cycle_with(double K_max, double K_min, double K_op) {
    CycleResult cycle;
    cycle.K_max = K_max;
    cycle.K_min = K_min;
    cycle.opening.K_op = K_op;
    cycle.opening_behind = {.most = 0.004, .least = 0.001};
    return cycle;
}

TEST(GrowthLaw, IsAsFastAsItsLawSays) {
    GrowthSection growth{.law = GrowthLaw::Paris, .increment = 0.1, .C = 1e-12, .m = 3.0};
    const CycleResult cycle = cycle_with(600.0, 100.0, 300.0);
    EXPECT_NEAR(growth_rate(growth, cycle), 1.25e-4, 1e-18);
    EXPECT_NEAR(growth_rate(growth, cycle_with(600.0, -600.0, 300.0)), 2.16e-4, 1e-18);  // E647: what opens it
    EXPECT_EQ(growth_rate(growth, cycle_with(-100.0, -600.0, 0.0)), 0.0);
    growth.driving = GrowthDriving::FullRange;
    EXPECT_NEAR(growth_rate(growth, cycle_with(600.0, -600.0, 300.0)), 1.728e-3, 1e-17);
    growth.driving = GrowthDriving::EffectiveRange;
    EXPECT_NEAR(growth_rate(growth, cycle), 2.7e-5, 1e-18);
    EXPECT_EQ(growth_rate(growth, cycle_with(600.0, 100.0, std::nan(""))), 0.0);  // it never opens
    growth = {.law = GrowthLaw::Ctod, .increment = 0.1, .C = 2.0, .m = 2.0};
    EXPECT_NEAR(growth_rate(growth, cycle), 2.0 * 0.003 * 0.003, 1e-15);
}

// Beside a dead load that opens the crack, cases cancel but for rounding: no life of 1e50 cycles.
TEST(GrowthLaw, RoundingDrivesNothing) {
    GrowthSection growth{.law = GrowthLaw::Paris, .increment = 0.1, .C = 1e-12, .m = 3.0};
    EXPECT_EQ(growth_rate(growth, cycle_with(500.0 + 1e-11, 500.0, 500.0)), 0.0);
    EXPECT_GT(growth_rate(growth, cycle_with(500.0 + 1e-5, 500.0, 500.0)), 0.0);
    EXPECT_TRUE(std::isnan(growth_rate(growth, cycle_with(std::nan(""), std::nan(""), 0.0))));
}

// Shear moves the faces of a crack that a dead load holds open, at a K_I that stands.
TEST(GrowthLaw, OpeningsDriveAtAConstantK) {
    const GrowthSection growth{.law = GrowthLaw::Ctod, .increment = 0.1, .C = 2.0, .m = 2.0};
    CycleResult cycle = cycle_with(500.0 + 1e-11, 500.0, 500.0);
    EXPECT_NEAR(growth_rate(growth, cycle), 2.0 * 0.003 * 0.003, 1e-15);
    cycle.opening_behind = {.most = 0.004 + 1e-15, .least = 0.004};
    EXPECT_EQ(growth_rate(growth, cycle), 0.0);
    cycle.opening_behind = {};
    EXPECT_TRUE(std::isnan(growth_rate(growth, cycle)));
}

TEST(GrowthLaw, ATableIsDrivenAsParisLawIs) {
    GrowthSection growth{.law = GrowthLaw::Table, .ranges = {100.0, 1000.0}, .rates = {1e-6, 1e-3}};
    const CycleResult cycle = cycle_with(600.0, 100.0, 300.0);
    EXPECT_NEAR(growth_rate(growth, cycle), 1.25e-4, 1e-16);
    growth.driving = GrowthDriving::EffectiveRange;
    EXPECT_NEAR(growth_rate(growth, cycle), 2.7e-5, 1e-16);
    EXPECT_EQ(growth_rate(growth, cycle_with(390.0, 100.0, 300.0)), 0.0);
    EXPECT_TRUE(grows_by_opening_loads(growth));
}

// 0 counts K_max alone, 1 the range.
TEST(GrowthLaw, CountsTheLoadRatioByWalkersExponent) {
    GrowthSection growth{.law = GrowthLaw::Paris, .C = 1e-12, .m = 2.0};
    const auto range = [&](double walker, double K_min) {
        growth.walker = walker;
        return std::sqrt(growth_rate(growth, cycle_with(800.0, K_min, 0.0)) / growth.C);
    };
    EXPECT_NEAR(range(0.5, 600.0), 400.0, 1e-9);
    EXPECT_NEAR(range(0.25, 750.0), 400.0, 1e-9);
    EXPECT_NEAR(range(0.0, 600.0), 800.0, 1e-9);
    EXPECT_NEAR(range(1.0, 600.0), 200.0, 1e-9);
    EXPECT_NEAR(range(0.5, -600.0), 800.0, 1e-9);
    growth.walker = 0.5;
    EXPECT_EQ(growth_rate(growth, cycle_with(-100.0, -600.0, 0.0)), 0.0);
}

TEST(GrowthLaw, LeapsWithTheK) {
    GrowthSection growth{.law = GrowthLaw::Paris, .C = 1e-12, .m = 3.0};
    EXPECT_NEAR(rate_behind_leap(growth, 1e-4, 0.5), 1.25e-5, 1e-17);
    EXPECT_TRUE(std::isnan(rate_behind_leap(growth, 1e-4, -0.5)));
    growth.threshold = 300.0;  // 1e-4 is of 464
    EXPECT_EQ(rate_behind_leap(growth, 1e-4, 0.5), 0.0);
    growth = {.law = GrowthLaw::Ctod, .C = 1.0, .m = 2.0};
    EXPECT_NEAR(rate_behind_leap(growth, 1e-4, 0.5), 1e-4 / 16.0, 1e-17);
    growth = {.law = GrowthLaw::Table, .ranges = {100.0, 200.0, 2000.0}, .rates = {1e-7, 3.2e-6, 3.2e-3}};
    EXPECT_NEAR(rate_behind_leap(growth, 3.2e-6 * 8.0, 0.375), 1e-7 * std::pow(1.5, 5.0), 1e-17);  // 400 to 150
}

// A constant stress that shears the tip turns it, and the range of the load, which opens it, loses by that.
TEST(GrowthLaw, LeapsAsTheRangeDoesWhereAConstantStressTurnsATip) {
    const auto tip = [](double K_I, double K_II) {
        TipResult result;
        result.K_I = K_I;
        result.K_II = K_II;
        return result;
    };
    const TipAtExtremes turning{tip(200.0, 60.0), tip(120.0, 60.0)};
    const double angle = hoop_stress_angle(200.0, 60.0), c = std::cos(0.5 * angle), s = std::sin(0.5 * angle);
    const double most = c * c * (200.0 * c - 180.0 * s), least = c * c * (120.0 * c - 180.0 * s);
    const CycleResult cycle = cycle_with(200.0, 120.0, 140.0);
    GrowthSection growth{.law = GrowthLaw::Paris, .C = 1e-12, .m = 3.0};
    EXPECT_NEAR(leap_at_turn(growth, cycle, turning, angle), c * c * c, 1e-12);
    EXPECT_GT(most, 1.1 * 200.0) << "all of K leaps up";
    growth.walker = 0.5;
    EXPECT_NEAR(leap_at_turn(growth, cycle, turning, angle), std::sqrt(most * (most - least) / (200.0 * 80.0)), 1e-12);
    growth.driving = GrowthDriving::EffectiveRange;
    EXPECT_NEAR(leap_at_turn(growth, cycle, turning, angle), c * c * c, 1e-12) << "three quarters of the range";
    // One load: all of its K leap alike, whatever the ratio.
    const TipAtExtremes alike{tip(200.0, 60.0), tip(0.0, 0.0)};
    for (const GrowthDriving driving :
         {GrowthDriving::Range, GrowthDriving::FullRange, GrowthDriving::EffectiveRange}) {
        growth.driving = driving;
        EXPECT_NEAR(leap_at_turn(growth, cycle, alike, angle), most / 200.0, 1e-12);
    }
}

// Pure shear: K of the turned crack is 2 / sqrt(3) of K_II, and the extremes may stand either way.
TEST(GrowthLaw, KnowsTheRateOfATipThatOnlyATurnStarts) {
    const auto sheared = [](double K_II) {
        TipResult result;
        result.K_II = K_II;
        return result;
    };
    GrowthSection growth{.law = GrowthLaw::Paris, .C = 1e-12, .m = 3.0};
    const double angle = hoop_stress_angle(0.0, 300.0), rate = 1e-12 * std::pow(600.0 / std::sqrt(3.0), 3.0);
    EXPECT_NEAR(rate_just_turned(growth, {sheared(300.0), sheared(0.0)}, angle), rate, 1e-12);
    EXPECT_NEAR(rate_just_turned(growth, {sheared(0.0), sheared(300.0)}, angle), rate, 1e-12);
    EXPECT_NEAR(rate_just_turned(growth, {sheared(300.0), sheared(150.0)}, angle), rate / 8.0, 1e-12);
    EXPECT_NEAR(rate_just_turned(growth, {sheared(300.0), sheared(-300.0)}, angle), rate, 1e-12) << "tension alone";
    EXPECT_EQ(rate_just_turned(growth, {sheared(1e-6), sheared(0.0)}, angle), 0.0) << "rounding";
    growth.threshold = 350.0;
    EXPECT_EQ(rate_just_turned(growth, {sheared(300.0), sheared(0.0)}, angle), 0.0);
    growth = {.law = GrowthLaw::Paris, .C = 1e-12, .m = 3.0, .driving = GrowthDriving::EffectiveRange};
    EXPECT_EQ(rate_just_turned(growth, {sheared(300.0), sheared(0.0)}, angle), 0.0);
}

TEST(GrowthLaw, KnowsNoRateWhereItsDriveIsNotFound) {
    CycleResult cycle = cycle_with(600.0, 100.0, std::nan(""));
    cycle.opening.lost = true;
    cycle.opening_behind = {};
    GrowthSection growth{.law = GrowthLaw::Paris, .increment = 0.1, .C = 1e-12, .m = 3.0};
    EXPECT_GT(growth_rate(growth, cycle), 0.0);
    growth.driving = GrowthDriving::EffectiveRange;
    EXPECT_TRUE(std::isnan(growth_rate(growth, cycle)));
    growth.law = GrowthLaw::Ctod;
    EXPECT_TRUE(std::isnan(growth_rate(growth, cycle)));
    CycleResult no_ring = cycle_with(std::nan(""), std::nan(""), std::nan(""));
    growth.law = GrowthLaw::Paris;
    for (const GrowthDriving driving :
         {GrowthDriving::Range, GrowthDriving::FullRange, GrowthDriving::EffectiveRange}) {
        growth.driving = driving;
        EXPECT_TRUE(std::isnan(growth_rate(growth, no_ring)));
    }
    EXPECT_TRUE(std::isnan(fastest_rate({1.0, std::nan(""), 2.0})));
    EXPECT_EQ(fastest_rate({1.0, 3.0, 2.0}), 3.0);
    EXPECT_EQ(fastest_of({1.0, 3.0, 2.0}), 1U);
    EXPECT_EQ(fastest_rate({}), 0.0);
}

TEST(GrowthLaw, LeadsWithTheFastestTip) {
    GrowthSection growth{.law = GrowthLaw::Paris, .increment = 0.1, .C = 1e-12, .m = 2.0};
    const std::vector<CycleResult> last{cycle_with(300.0, 0.0, 0.0), cycle_with(600.0, 0.0, 0.0)};
    const std::vector<double> found = shares_of_advance(growth, growth_rates(growth, last), 2);
    EXPECT_NEAR(found[0], 0.25, 1e-14);
    EXPECT_EQ(found[1], 1.0);
    growth.law = GrowthLaw::Prescribed;
    EXPECT_EQ(shares_of_advance(growth, {}, 2), (std::vector<double>{1.0, 1.0}));
    EXPECT_EQ(shares_of_advance(growth, growth_rates(growth, last), 2), (std::vector<double>{1.0, 1.0}));
}

TEST(GrowthLaw, TakesTheCyclesBetweenTwoRates) {
    EXPECT_NEAR(cycles_passed(0.1, 1e-4, 2e-4), 750.0, 1e-9);
    EXPECT_EQ(cycles_passed(0.0, 0.0, 2e-4), 0.0);
}

// Of a rate exp(k a) the cycles are known.
TEST(GrowthLaw, SaysWhatTheTrapezoidsAreOffBy) {
    for (const double k : {-3.0, 1.0, 1e-2}) {
        const double a = 0.7, rate = 1e-5, exact = (1.0 - std::exp(-k * a)) / k / rate;
        const double passed = cycles_passed(a, rate, rate * std::exp(k * a));
        EXPECT_NEAR(cycles_in_doubt({a, rate, rate * std::exp(k * a)}), passed - exact, 1e-9 * passed);
    }
    EXPECT_EQ(cycles_in_doubt({0.7, 1e-5, 1e-5}), 0.0);
    EXPECT_EQ(cycles_in_doubt({0.0, 0.0, 1e-5}), 0.0);
}

// K goes with the root of the length, from 10 to 30 mm at once: with the exponential between the ends 18 instead of 29
// % of the cycles are in doubt.
TEST(GrowthLaw, TrapezoidsOfAPowerOfTheLengthAreOffByMore) {
    const double m = 3.0, C = 1e-7, a = 10.0;
    const auto rate = [&](double length) { return C * std::pow(length, m / 2.0); };
    for (const double grown : {20.0, 1.0, 1e-2}) {
        const double passed = cycles_passed(grown, rate(a), rate(a + grown)),
                     exact = 2.0 / C * (1.0 / std::sqrt(a) - 1.0 / std::sqrt(a + grown));
        EXPECT_NEAR(cycles_in_doubt({grown, rate(a), rate(a + grown), a, grown}) / (passed - exact), 1.0, 1e-6);
    }
    // Of two tips one grows by twice as much as half the crack: rate and length double.
    const double of_power = 20.0 * std::log(2.0) / rate(a);
    EXPECT_NEAR(cycles_in_doubt({20.0, rate(a), 2.0 * rate(a), a, 10.0}), 15.0 / rate(a) - of_power, 1e-9 * of_power);
    // The rate falls, or the length is not known.
    const double of_exponential = cycles_in_doubt({20.0, rate(a), rate(2.0 * a)});
    EXPECT_EQ(cycles_in_doubt({20.0, rate(a), rate(2.0 * a), -1.0, 20.0}), of_exponential);
    EXPECT_EQ(cycles_in_doubt({20.0, rate(2.0 * a), rate(a), a, 20.0}), of_exponential);
}

}  // namespace
}  // namespace stria::coarse
