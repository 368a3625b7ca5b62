// How long a quadrilateral is in a direction.
#include "common/fem/chord.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace stria {
namespace {

constexpr double rounding = 1e-14;

TEST(Chord, OfARectangleEndsOnTheNearerSides) {
    const std::array<Vec2, 4> corners{Vec2(3.0, 1.0), Vec2(5.6, 1.0), Vec2(5.6, 3.0), Vec2(3.0, 3.0)};  // 2.6 x 2
    EXPECT_NEAR(chord(corners, Vec2(1.0, 0.0)), 2.6, rounding);
    EXPECT_NEAR(chord(corners, Vec2(0.0, -1.0)), 2.0, rounding);
    for (const double degrees : {20.0, 37.0, 38.0, 80.0, 130.0}) {
        const double c = std::cos(degrees * std::numbers::pi / 180.0), s = std::sin(degrees * std::numbers::pi / 180.0);
        EXPECT_NEAR(chord(corners, Vec2(c, s)), std::min(2.6 / std::abs(c), 2.0 / std::abs(s)), rounding) << degrees;
    }
}

TEST(Chord, OfARhombusAlongItsDiagonalsIsTheyThemselves) {
    const std::array<Vec2, 4> corners{Vec2(-2.0, 0.0), Vec2(0.0, -1.0), Vec2(2.0, 0.0), Vec2(0.0, 1.0)};
    EXPECT_NEAR(chord(corners, Vec2(1.0, 0.0)), 4.0, rounding);
    EXPECT_NEAR(chord(corners, Vec2(0.0, 1.0)), 2.0, rounding);
}

}  // namespace
}  // namespace stria
