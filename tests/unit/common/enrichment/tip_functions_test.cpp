// Eq. (2): the tip functions' gradients, and their jump across the faces.
#include "common/enrichment/tip_functions.hpp"

#include <gtest/gtest.h>

#include "common/geometry/vec2.hpp"

namespace stria::test {
namespace {

const Tip inclined{.crack = 0, .position = {0.3, -0.2}, .direction = {0.8, 0.6}, .s = 1.0, .upper = 1};
const Tip reversed{.crack = 0, .position = {0.3, -0.2}, .direction = {-0.8, -0.6}, .s = 0.0, .upper = -1};

/// Vec2 at polar coordinates of the tip's frame.
Vec2 point(const Tip& tip, double r, double theta) {
    const Vec2 across(-tip.direction.y(), tip.direction.x());
    return tip.position + r * (std::cos(theta) * tip.direction + std::sin(theta) * across);
}

TEST(TipFunctions, GradientsMatchDifferences) {
    constexpr double step = 1e-6;
    for (const Tip& tip : {inclined, reversed}) {
        for (const double n : {1.0, 3.0, 13.0}) {
            for (const double theta : {-3.0, -1.2, 0.0, 0.7, 2.1, 3.1}) {
                const int side = theta == 0.0 ? 0 : (theta > 0.0 ? 1 : -1) * tip.upper;
                const Vec2 x = point(tip, 0.4, theta);
                const TipFunctions exact = tip_functions(tip, x, side, 1.0 / (n + 1.0));
                for (int axis = 0; axis < 2; ++axis) {
                    const Vec2 shift = step * Vec2::Unit(axis);
                    const TipFunctions after = tip_functions(tip, x + shift, side, 1.0 / (n + 1.0));
                    const TipFunctions before = tip_functions(tip, x - shift, side, 1.0 / (n + 1.0));
                    const Eigen::VectorXd difference = (after.value - before.value) / (2.0 * step);
                    EXPECT_LT((difference - exact.gradient.col(axis)).norm(), 1e-8) << n << " " << theta;
                }
            }
        }
    }
}

TEST(TipFunctions, ValuesAreEquation2) {
    const double r = 0.7, t = 1.1, p = 0.25;
    const Vec2 half(std::sin(t / 2.0), std::cos(t / 2.0));
    const Eigen::VectorXd value = tip_functions(inclined, point(inclined, r, t), 0, p).value;
    for (int pair = 0; pair < 3; ++pair) {
        const double factor = pair == 0 ? 1.0 : std::sin(pair == 1 ? t : 3.0 * t);
        EXPECT_LT((value.segment<2>(2 * pair) - std::pow(r, p) * factor * half).norm(), 1e-15);
    }
}

TEST(TipFunctions, OnlyTheFirstJumpsAcrossTheFaces) {
    for (const Tip& tip : {inclined, reversed}) {
        const Vec2 x = point(tip, 0.5, std::numbers::pi);
        const TipFunctions upper = tip_functions(tip, x, tip.upper, 0.5),
                           lower = tip_functions(tip, x, -tip.upper, 0.5);
        const Eigen::VectorXd jump = upper.value - lower.value;
        EXPECT_NEAR(jump[0], 2.0 * std::sqrt(0.5), 1e-12);
        EXPECT_LT(jump.tail<5>().norm(), 1e-12);
    }
}

TEST(TipFunctions, AKinkBehindTheTipTearsNothing) {
    const double beyond = std::numbers::pi + 0.3;  // on the plus side, past the straight line behind the tip
    EXPECT_NEAR(tip_polar(inclined, point(inclined, 1.0, beyond), 1).theta, beyond, 1e-12);
    EXPECT_NEAR(tip_polar(inclined, point(inclined, 1.0, -beyond), -1).theta, -beyond, 1e-12);
}

}  // namespace
}  // namespace stria::test
