// Mean rates of the cycles from one growth to the next.
#include "coarse/growth/period_rates.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria::coarse {
namespace {

using Tips = std::vector<double>;

TEST(PeriodRates, AreMeansFromOneGrowthToTheNext) {
    PeriodRates rates;
    EXPECT_TRUE(rates.present().empty());
    rates.add({1.0, 2.0}, {0.0, 0.0}, true);
    rates.add({3.0, 6.0}, {0.0, 0.0}, false);
    EXPECT_EQ(rates.present(), (Tips{2.0, 4.0}));
    EXPECT_TRUE(rates.before().empty());
    rates.add({5.0, 1.0}, {0.1, 0.2}, true);
    EXPECT_EQ(rates.before(), (Tips{2.0, 4.0}));
    PeriodRates resumed(rates.memory());
    resumed.add({7.0, 2.0}, {0.0, 0.0}, false);
    EXPECT_EQ(resumed.present(), (Tips{6.0, 1.5}));
    EXPECT_EQ(resumed.before(), (Tips{2.0, 4.0}));
    EXPECT_EQ(resumed.grown(), (Tips{0.1, 0.2}));
}

TEST(PeriodRates, AreNotKnownWhereOneIsNot) {
    PeriodRates rates;
    rates.add({std::nan("")}, {0.0}, true);
    rates.add({1.0}, {0.0}, false);
    EXPECT_TRUE(std::isnan(rates.present().at(0)));
    rates.add({1.0}, {0.0}, true);
    EXPECT_EQ(rates.present(), Tips{1.0});
}

// By logarithms, half of what they changed by over the growth before; a leap is cut, and zero is no trend.
TEST(PeriodRates, GoOnToTheMiddleOfTheNextGrowth) {
    PeriodRates rates;
    rates.add({1.0, 1.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 0.0}, true);
    EXPECT_EQ(rates.ahead(), rates.present());
    rates.add({4.0, 0.25, 100.0, 3.0}, {0.1, 0.1, 0.1, 0.0}, true);
    EXPECT_EQ(rates.ahead(), (Tips{8.0, 0.125, 200.0, 3.0}));
    rates.add({4.0, 1.0, 1.0, 4.0}, {0.0, 0.0, 0.0, 0.0}, true);  // without growth: the trend is that of the last one
    EXPECT_EQ(rates.ahead(), (Tips{8.0, 1.0, 1.0, 4.0}));
    EXPECT_EQ(PeriodRates(rates.memory()).ahead(), rates.ahead());
}

}  // namespace
}  // namespace stria::coarse
