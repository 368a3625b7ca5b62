#include "app/run/pace.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria::test {
namespace {

TEST(Pace, IsThatOfTheCyclesSinceTheFirstState) {
    Pace pace(100, std::nullopt);
    EXPECT_TRUE(std::isinf(pace.seconds_left(-0.4, 10.0, 3.0)));  // on the ramp, after reading
    EXPECT_NEAR(pace.seconds_left(1.6, 10.0, 7.0), 4.0 * 98.4 / 2.0, 1e-9);
    EXPECT_EQ(pace.seconds_left(100.0, 10.0, 300.0), 0.0);
    Pace resumed(100, std::nullopt);
    EXPECT_TRUE(std::isinf(resumed.seconds_left(90.0, 10.0, 3.0)));
    EXPECT_NEAR(resumed.seconds_left(95.0, 10.0, 8.0), 5.0, 1e-9);
}

// The crack is long enough well before the cycles are over, or not at all.
TEST(Pace, EndsWithTheCrackWhereThatIsSooner) {
    Pace pace(1000, 12.0);
    EXPECT_TRUE(std::isinf(pace.seconds_left(-0.5, 10.0, 0.0)));
    EXPECT_NEAR(pace.seconds_left(9.5, 10.0, 10.0), 990.5, 1e-9);
    EXPECT_NEAR(pace.seconds_left(19.5, 10.5, 20.0), 20.0 * 1.5 / 0.5, 1e-9);
    EXPECT_NEAR(pace.seconds_left(999.5, 10.6, 1000.0), 0.5, 1e-9);
    EXPECT_EQ(pace.seconds_left(999.6, 12.1, 1000.1), 0.0);
}

}  // namespace
}  // namespace stria::test
