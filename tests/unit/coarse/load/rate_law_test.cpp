// da/dN as a curve: powers with a threshold, and tables.
#include "coarse/load/rate_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria::coarse {
namespace {

TEST(RateLaw, NothingGrowsBelowTheThreshold) {
    const GrowthSection growth{.law = GrowthLaw::Paris, .C = 1e-12, .m = 3.0, .threshold = 150.0};
    EXPECT_EQ(rate_of_range(growth, 149.9), 0.0);
    EXPECT_NEAR(rate_of_range(growth, 150.0), 3.375e-6, 1e-18);
    EXPECT_EQ(rate_of_range(growth, std::nan("")), 0.0);
    EXPECT_NEAR(range_of_rate(growth, 8e-6), 200.0, 1e-9);
}

// Slopes of 5 and 3; the last line goes on.
TEST(RateLaw, ATableIsMadeOfStraightLinesOfLogarithms) {
    const GrowthSection growth{
        .law = GrowthLaw::Table, .ranges = {100.0, 200.0, 2000.0}, .rates = {1e-7, 3.2e-6, 3.2e-3}};
    EXPECT_EQ(rate_of_range(growth, 99.9), 0.0);
    EXPECT_NEAR(rate_of_range(growth, 100.0), 1e-7, 1e-20);
    EXPECT_NEAR(rate_of_range(growth, 150.0), 1e-7 * std::pow(1.5, 5.0), 1e-18);
    EXPECT_NEAR(rate_of_range(growth, 200.0), 3.2e-6, 1e-18);
    EXPECT_NEAR(rate_of_range(growth, 600.0), 3.2e-6 * 27.0, 1e-17);
    EXPECT_NEAR(rate_of_range(growth, 4000.0), 3.2e-3 * 8.0, 1e-14);
    for (const double range : {120.0, 200.0, 700.0, 5000.0})
        EXPECT_NEAR(range_of_rate(growth, rate_of_range(growth, range)), range, 1e-9 * range);
    EXPECT_NEAR(exponent_of_K(growth), std::log(3.2e4) / std::log(20.0), 1e-12);
}

}  // namespace
}  // namespace stria::coarse
