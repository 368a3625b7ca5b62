// Which of the increments taken before tells the next one.
#include "coarse/load/taken_increment.hpp"

#include <gtest/gtest.h>

#include <array>

namespace stria::coarse {
namespace {

TakenIncrement taken(int cycle, double from, double to) { return {.cycle = cycle, .from = from, .to = to}; }

/// With the factors of two load cases.
TakenIncrement taken(int cycle, std::array<double, 3> from, std::array<double, 3> to) {
    return {cycle, from[0], to[0], Eigen::Vector2d(from[1], from[2]), Eigen::Vector2d(to[1], to[2])};
}

TEST(Predictors, AreNothingWhereNothingHasBeenTaken) { EXPECT_EQ(predictor_from({}, taken(1, 0.0, 1.0)), Predictor()); }

TEST(Predictors, AreNearlyTheSameIncrementOfACycleBefore) {
    const std::vector<TakenIncrement> before{taken(1, 2.0, 1.0), taken(1, 1.0, 2.0), taken(1, 0.0, 1.0)};
    EXPECT_EQ(predictor_from(before, taken(2, 1.0, 2.0)), Predictor(1.0, 2));
    const Predictor near = predictor_from(before, taken(2, 1.09, 2.0));
    EXPECT_EQ(near.back, 2) << "a tenth of it may be another";
    EXPECT_NEAR(near.factor, 0.91, 1e-14);
    EXPECT_EQ(predictor_from(before, taken(2, 0.8, 2.0)).back, 1);
    EXPECT_EQ(predictor_from(before, taken(1, 1.0, 2.0)).back, 1) << "of the same cycle";
}

// Virgin material flows where it will later unload and reload without.
TEST(Predictors, AreNoIncrementOfTheRamp) {
    EXPECT_EQ(predictor_from({taken(1, 2.0, 1.0), taken(0, 1.0, 2.0)}, taken(1, 1.0, 2.0)), Predictor(0.0));
}

TEST(Predictors, AreElseTheLastOneInProportionButNotBack) {
    EXPECT_EQ(predictor_from({taken(1, 0.0, 1.0)}, taken(1, 1.0, 1.5)), Predictor(0.5));
    EXPECT_EQ(predictor_from({taken(1, 0.0, 1.0)}, taken(1, 1.0, 0.5)), Predictor(0.0)) << "a reversal";
    EXPECT_EQ(predictor_from({taken(1, 1.0, 1.0)}, taken(1, 1.0, 2.0)), Predictor(0.0)) << "of no length";
}

// Loads that change in different proportion: what one has of the other, along it.
TEST(Predictors, GoAlongAllLoads) {
    const TakenIncrement last = taken(1, {0.0, 0.0, 1.0}, {3.0, 4.0, 1.0});
    EXPECT_DOUBLE_EQ(predictor_from({last}, taken(1, {3.0, 4.0, 1.0}, {4.0, 6.0, 7.0})).factor, 11.0 / 25.0);
    EXPECT_EQ(predictor_from({last}, taken(2, {0.0, 0.0, 1.0}, {3.0, 4.0, 1.0})), Predictor(1.0, 1));
    // Another case beside the same main load is no twin.
    const std::vector<TakenIncrement> two{taken(1, {3.0, 0.0, 0.0}, {0.0, 0.0, 0.0}), last};
    EXPECT_EQ(predictor_from(two, taken(2, {0.0, 0.0, 1.0}, {3.0, 2.0, 1.0})).back, 1);
}

}  // namespace
}  // namespace stria::coarse
