// Which way a tip turns, and its K just behind the turn.
#include "coarse/fracture/turned_tip.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

namespace stria::coarse {
namespace {

TEST(TurnedTip, GoesAcrossTheLargestHoopStress) {
    constexpr double degree = std::numbers::pi / 180.0;
    for (const auto& [b, angle] : {std::pair{30.0, -60.0}, {45.0, -53.1301}, {60.0, -43.2213}}) {
        const double K_I = std::sin(b * degree), K_II = std::cos(b * degree);
        EXPECT_NEAR(hoop_stress_angle(K_I, K_II) / degree, angle, 1e-4);
        EXPECT_NEAR(hoop_stress_angle(K_I, -K_II) / degree, -angle, 1e-4);
    }
    EXPECT_NEAR(hoop_stress_angle(0.0, 1.0) / degree, -70.5288, 1e-4);
    EXPECT_NEAR(hoop_stress_angle(1.0, 1e-9), -2e-9, 1e-17);
    EXPECT_NEAR(hoop_stress_angle(-1.0, 1.0) / degree, -70.5288, 1e-4);  // no further than in pure shear
    EXPECT_EQ(hoop_stress_angle(0.0, 0.0), 0.0);                         // no ring has seen a field
    EXPECT_EQ(hoop_stress_angle(-1.0, 1e-9), 0.0);                       // the load closes it
}

// The largest of all directions; in pure shear 2 / sqrt(3) of K_II.
TEST(TurnedTip, HasTheKOfTheStressAcrossItsNewWay) {
    const TipResult mixed{.K_I = 1.0, .K_II = 1.0};
    EXPECT_EQ(K_just_turned(mixed, 0.0), 1.0);
    const double best = hoop_stress_angle(1.0, 1.0), K = K_just_turned(mixed, best);
    for (const double off : {-0.01, 0.01}) EXPECT_LT(K_just_turned(mixed, best + off), K);
    EXPECT_NEAR(K_just_turned({.K_I = 0.0, .K_II = 1.0}, hoop_stress_angle(0.0, 1.0)), 2.0 / std::numbers::sqrt3,
                1e-12);
    EXPECT_EQ(K_just_turned({.K_I = 1.0, .K_II = -1.0}, -best), K);
}

TEST(TurnedTip, BreaksByTheLargerOfBoth) {
    const TipResult sheared{.K_I = 100.0, .K_II = 174.0};
    EXPECT_EQ(K_at_break(sheared), K_just_turned(sheared, hoop_stress_angle(100.0, 174.0)));
    EXPECT_GT(K_at_break(sheared), 230.0);
    EXPECT_EQ(K_at_break({.K_I = 100.0, .K_II = 5.0}), 100.0);  // turns by less than ten degrees
    EXPECT_EQ(K_at_break({.K_I = -100.0, .K_II = 0.1}), -100.0);
}

}  // namespace
}  // namespace stria::coarse
