#include "coarse/load/growth_schedule.hpp"

#include <gtest/gtest.h>

namespace stria::coarse {
namespace {

TEST(GrowthSchedule, ComesWithTheCyclesAsked) {
    GrowthSection growth;
    growth.increment = 0.1;
    growth.every = 2;
    LoadStep step;
    step.cycle = 2;
    EXPECT_FALSE(grows_at(growth, step));
    step.ends_cycle = true;
    EXPECT_TRUE(grows_at(growth, step));
    step.cycle = 3;
    EXPECT_FALSE(grows_at(growth, step));
    growth.every = 1;
    growth.at = GrowthAt::Minimum;
    EXPECT_FALSE(grows_at(growth, step));
    step.at_minimum = true;
    EXPECT_TRUE(grows_at(growth, step));
}

/// A peak among smaller cycles, twice; a law of da/dN.
Case spectrum(int every) {
    Case input;
    input.load.blocks = {{.cycles = 4, .max = 1.0, .min = 0.1}, {.cycles = 1, .max = 2.0, .min = 0.1}};
    input.load.repeat = 2;
    input.growth = GrowthSection{.law = GrowthLaw::Paris, .increment = 0.1, .every = every, .C = 1.0, .m = 3.0};
    return input;
}

TEST(GrowthSchedule, TakesMeansOfALoadThatVaries) {
    EXPECT_FALSE(takes_mean_rate(spectrum(1)));
    EXPECT_TRUE(takes_mean_rate(spectrum(5)));
    Case alike = spectrum(5);
    alike.load.blocks[1].max = 1.0;
    EXPECT_FALSE(takes_mean_rate(alike));
    alike.load_cases.emplace_back().blocks = {{.cycles = 1, .at_max = 1.0, .at_min = 0.0},
                                              {.cycles = 9, .at_max = 1.0, .at_min = 0.5}};
    EXPECT_TRUE(takes_mean_rate(alike));
    Case prescribed = spectrum(5);
    prescribed.growth->law = GrowthLaw::Prescribed;
    EXPECT_FALSE(takes_mean_rate(prescribed));
}

TEST(GrowthSchedule, EndsAPeriodBeforeTheNextGrowthCounts) {
    GrowthSection growth{.every = 3};
    EXPECT_TRUE(ends_period(growth, 3));
    EXPECT_FALSE(ends_period(growth, 2));
    growth.at = GrowthAt::Minimum;
    EXPECT_TRUE(ends_period(growth, 2));  // the third cycle rises with the longer crack
    EXPECT_FALSE(ends_period(growth, 3));
}

TEST(GrowthSchedule, WarnsOfCyclesThatTheLoadDoesNotHave) {
    EXPECT_TRUE(growth_warnings(spectrum(5)).empty());
    EXPECT_TRUE(growth_warnings(spectrum(10)).empty());
    ASSERT_EQ(growth_warnings(spectrum(1)).size(), 1U);
    EXPECT_NE(growth_warnings(spectrum(1))[0].find("growth.every = 5 takes"), std::string::npos);
    ASSERT_EQ(growth_warnings(spectrum(4)).size(), 1U);
    EXPECT_NE(growth_warnings(spectrum(4))[0].find("no multiple of the 5 cycles"), std::string::npos);
}

// K_op of a crack that nothing closes is K_min, whatever its faces do.
TEST(GrowthSchedule, WarnsOfOpeningLoadsOfCracksThatNeverClose) {
    Case input = spectrum(5);
    input.growth->driving = GrowthDriving::EffectiveRange;
    input.cracks.assign(2, {.points = {{0.0, 1.0}, {1.0, 1.0}}, .contact = ContactSection{}});
    EXPECT_TRUE(growth_warnings(input).empty());
    input.cracks[1].contact.reset();
    ASSERT_EQ(growth_warnings(input).size(), 1U);
    input.growth->law = GrowthLaw::Prescribed;
    EXPECT_TRUE(growth_warnings(input).empty());
}

}  // namespace
}  // namespace stria::coarse
