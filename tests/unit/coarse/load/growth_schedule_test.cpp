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

}  // namespace
}  // namespace stria::coarse
