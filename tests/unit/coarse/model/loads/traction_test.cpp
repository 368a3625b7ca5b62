// Pressures that are distributed: their resultants, moments and ends.
#include "coarse/model/loads/traction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stria::coarse {
namespace {

struct Resultant {
    Vec2 force = Vec2::Zero();
    double moment = 0.0;  // about the origin
};

/// Of a row of edges between points.
Resultant resultant(const Traction& traction, const std::vector<Vec2>& points) {
    Resultant sum;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const EdgeGeometry edge{points[k], points[k + 1]};
        for (const auto& [fraction, length] : edge_points(traction, edge, 0.0, 1.0, 2)) {
            const Vec2 x = edge.at(fraction), force = length * traction.at(x, edge.inward_normal());
            sum.force += force;
            sum.moment += cross(x, force);
        }
    }
    return sum;
}

/// The top of a body from x = 10 to 0, in edges of uneven length.
std::vector<Vec2> top() {
    return {{10.0, 4.0}, {7.3, 4.0}, {6.9, 4.0}, {5.0, 4.0}, {3.1, 4.0}, {2.95, 4.0}, {0.0, 4.0}};
}

Traction hertz(double middle, double half_width) {
    Traction traction;
    traction.origin = {1.0, 0.0};
    traction.hertz = {.p0 = 300.0, .half_width = half_width, .middle = middle, .friction = 0.1};
    return traction;
}

TEST(Traction, HertzPressureHasItsResultantWhereverItEnds) {
    for (const double half_width : {0.07, 0.5, 1.3})
        for (double middle = 1.4; middle < 7.5; middle += 0.37) {
            const Resultant sum = resultant(hertz(middle, half_width), top());
            const double P = 0.5 * std::numbers::pi * 300.0 * half_width;
            EXPECT_NEAR(sum.force.y(), -P, 1e-12 * P);
            EXPECT_NEAR(sum.force.x(), 0.1 * P, 1e-12 * P);
            EXPECT_NEAR(sum.moment, -P * (middle + 1.0) - 4.0 * 0.1 * P, 1e-11 * P) << middle << " " << half_width;
        }
}

TEST(Traction, OfHertzPressureOnlyWhatIsOnTheEdgeCounts) {
    const Resultant sum = resultant(hertz(-1.0, 1.0), top());  // its middle is the corner
    const double P = 0.5 * std::numbers::pi * 300.0;
    EXPECT_NEAR(sum.force.y(), -0.5 * P, 1e-12 * P);
    EXPECT_NEAR(sum.moment + 4.0 * 0.1 * 0.5 * P, -300.0 / 3.0, 1e-11 * P);  // p0 a^2 / 3
}

TEST(Traction, AlongAnUprightEdgePlacesCountUpwards) {
    Traction traction = hertz(2.0, 0.5);
    traction.origin = {0.0, 1.0};
    const Resultant sum = resultant(traction, {{5.0, 0.0}, {5.0, 3.2}, {5.0, 6.0}});  // the right side
    const double P = 0.25 * std::numbers::pi * 300.0;
    EXPECT_NEAR(sum.force.x(), -P, 1e-12 * P);
    EXPECT_NEAR(sum.force.y(), 0.1 * P, 1e-12 * P);
    EXPECT_NEAR(sum.moment, 3.0 * P + 5.0 * 0.1 * P, 1e-11 * P);
}

/// A hole of radius 2 about (1, 1) in a polygon of edges; the body is outside.
std::vector<Vec2> hole(int edges) {
    std::vector<Vec2> points;
    for (int k = 0; k <= edges; ++k) {
        const double angle = -2.0 * std::numbers::pi * k / edges;
        points.emplace_back(1.0 + 2.0 * std::cos(angle), 1.0 + 2.0 * std::sin(angle));
    }
    return points;
}

// A pin presses on half of a hole: p r pi / 2 along its direction, and nothing across it.
TEST(Traction, ACosineOverAHoleHasTheResultantOfAPin) {
    const Vec2 direction = Vec2(1.0, 2.0).normalized();
    for (const bool radial : {false, true}) {
        Traction traction;
        traction.pressure = 50.0;
        traction.cosine = {direction, radial ? std::optional(Vec2(1.0, 1.0)) : std::nullopt};
        const Resultant sum = resultant(traction, hole(720));
        const double P = 50.0 * 2.0 * std::numbers::pi / 2.0;
        EXPECT_LT((sum.force - P * direction).norm(), 1e-4 * P) << radial;
        EXPECT_NEAR(sum.moment, P * (direction.y() - direction.x()), 1e-4 * P) << radial;
        EXPECT_TRUE(traction.at(Vec2(1.0, 1.0) - 2.0 * direction, -direction).isZero());
    }
}

// On a flat edge half of which the pin's cosine reaches: t = p d . r r.
TEST(Traction, ACosineEndsWithinAnEdge) {
    Traction traction;
    traction.pressure = 1.0;
    traction.cosine = {Vec2(1.0, 0.0), Vec2(0.0, -1.0)};
    const Resultant sum = resultant(traction, {{-2.0, 0.0}, {2.0, 0.0}});
    // Integrals over x from 0 to 2 of x^2 / (1 + x^2) and of x / (1 + x^2).
    EXPECT_NEAR(sum.force.x(), 2.0 - std::atan(2.0), 1e-10);
    EXPECT_NEAR(sum.force.y(), 0.5 * std::log(5.0), 1e-10);
}

}  // namespace
}  // namespace stria::coarse
