// From values of a load history to load factors, whatever is controlled.
#include "coarse/load/load_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/error.hpp"

namespace stria::coarse {
namespace {

const UnitResponse nominal{.K_I = {20.0, 30.0}, .displacement = {0.5, 0.6}};

LoadSection history(Control control) {
    return {.blocks = {{.cycles = 3, .max = 100.0, .min = 10.0}}, .scale = 2.0, .control = control};
}

TEST(LoadScale, OfLoadsIsOne) {
    const LoadSection load = history(Control::Load);
    EXPECT_EQ(target_of_unit(load, nominal.K_I, 1.0), 1.0);
    EXPECT_EQ(largest_load_factor(load, nominal), 200.0);
    EXPECT_EQ(largest_K_I(load, nominal), (std::vector<double>{4000.0, 6000.0}));
}

// One peak in ten cycles makes more than half of the growth where its exponent is 4: 16 of 25 parts.
TEST(LoadScale, APeakStandsForTheCyclesWhereItMakesHalfOfTheGrowth) {
    Case input;
    input.load = {.blocks = {{9, 50.0, 0.0}, {1, 100.0, 0.0}}, .scale = 2.0};
    EXPECT_EQ(common_K_I(input, nominal), (std::vector<double>{4000.0, 6000.0}));  // nothing grows
    input.growth = GrowthSection{.increment = 0.1};
    EXPECT_EQ(common_K_I(input, nominal), (std::vector<double>{2000.0, 3000.0}));
    input.growth->law = GrowthLaw::Paris;
    input.growth->m = 3.0;
    EXPECT_EQ(common_K_I(input, nominal).front(), 2000.0);
    input.growth->m = 4.0;
    EXPECT_EQ(common_K_I(input, nominal).front(), 4000.0);
    input.growth->law = GrowthLaw::Ctod;
    input.growth->m = 2.0;
    EXPECT_EQ(common_K_I(input, nominal).front(), 4000.0);
}

TEST(LoadScale, OfDisplacementsIsThatOfTheNominalBody) {
    const LoadSection load = history(Control::Displacement);
    EXPECT_EQ(target_of_unit(load, nominal.K_I, 1.0), 1.0);  // a target is a displacement
    EXPECT_EQ(largest_load_factor(load, nominal), 400.0);
    EXPECT_THROW(static_cast<void>(largest_load_factor(load, {.displacement = {0.0, 0.6}})), CaseError);
}

TEST(LoadScale, OfStressIntensitiesFollowsTheFirstTipAndTheGradient) {
    LoadSection load = history(Control::StressIntensity);
    EXPECT_EQ(largest_load_factor(load, nominal), 10.0);
    EXPECT_EQ(largest_K_I(load, nominal).front(), 200.0);
    load.K_gradient = -0.08;
    EXPECT_DOUBLE_EQ(target_of_unit(load, nominal.K_I, 2.0), std::exp(-0.16) / 20.0);
    EXPECT_THROW(static_cast<void>(target_of_unit(load, {-1.0, 30.0}, 0.0)), CaseError);
    EXPECT_THROW(static_cast<void>(target_of_unit(load, {}, 0.0)), CaseError);
}

}  // namespace
}  // namespace stria::coarse
