// Quadrature rules: polynomial exactness, and the singular rule against closed forms.
#include "common/fem/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria {
namespace {

const std::array<Vec2, 3> triangle{Vec2{0.3, -0.2}, Vec2{1.9, 0.4}, Vec2{0.1, 1.3}};

/// Integral of 1/r over a triangle from its vertex a: d (asinh(c/d) - asinh(b/d)), d the distance of the opposite side
/// and b, c the places of its ends along it.
double integral_of_inverse_distance(const std::array<Vec2, 3>& t) {
    const Vec2 side = (t[2] - t[1]).normalized();
    const double from = side.dot(t[1] - t[0]), to = side.dot(t[2] - t[0]);
    const double distance = (t[1] - t[0] - from * side).norm();
    return distance * (std::asinh(to / distance) - std::asinh(from / distance));
}

/// Integral of the monomial l1^i l2^j over a triangle of area A: 2 A i! j! / (i + j + 2)!.
double integral_of_monomial(int i, int j, double area) {
    return 2.0 * area * std::tgamma(i + 1.0) * std::tgamma(j + 1.0) / std::tgamma(i + j + 3.0);
}

TEST(GaussLine, IsExactToTwiceItsPointsLessOne) {
    for (int n = 1; n <= max_gauss_points; ++n) {
        for (int degree = 0; degree < 2 * n; ++degree) {
            double sum = 0.0;
            for (const LinePoint& point : gauss_line(n)) sum += point.weight * std::pow(point.xi, degree);
            EXPECT_NEAR(sum, degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0, 4e-15) << n << ' ' << degree;
        }
    }
}

TEST(GaussLine, RefusesOtherSizes) {
    EXPECT_THROW(static_cast<void>(gauss_line(0)), std::logic_error);
    EXPECT_THROW(static_cast<void>(gauss_line(33)), std::logic_error);
}

TEST(GaussSquare, IntegratesProducts) {
    double sum = 0.0;
    for (const SquarePoint& point : gauss_square(3)) {
        sum += point.weight * std::pow(point.xi.x(), 4) * std::pow(point.xi.y(), 2);
    }
    EXPECT_NEAR(sum, 2.0 / 5.0 * 2.0 / 3.0, 1e-15);
    EXPECT_LT(gauss_square(2)[0].xi.x(), gauss_square(2)[1].xi.x());
    EXPECT_EQ(gauss_square(2)[0].xi.y(), gauss_square(2)[1].xi.y());
}

TEST(TriangleRules, AreExactToTheirDegree) {
    for (const int degree : {2, 5}) {
        const auto rule = degree == 2 ? triangle_degree_2() : triangle_degree_5();
        for (int i = 0; i <= degree; ++i) {
            for (int j = 0; i + j <= degree; ++j) {
                double sum = 0.0;
                for (const TrianglePoint& point : rule) {
                    sum += point.weight * std::pow(point.barycentric[1], i) * std::pow(point.barycentric[2], j);
                }
                EXPECT_NEAR(sum, integral_of_monomial(i, j, 1.0), 1e-15) << degree << ' ' << i << ' ' << j;
            }
        }
    }
}

TEST(TriangleRules, KeepAreaAndCentroidWherePlaced) {
    double area = 0.0;
    Vec2 moment = Vec2::Zero();
    for (const PlacedPoint& point : placed_on_triangle(triangle_degree_2(), triangle)) {
        area += point.weight;
        moment += point.weight * point.x;
    }
    EXPECT_NEAR(area, triangle_area(triangle[0], triangle[1], triangle[2]), 1e-15);
    EXPECT_LT((moment / area - (triangle[0] + triangle[1] + triangle[2]) / 3.0).norm(), 1e-15);
}

TEST(CollapsedRule, ConvergesOnTheSquareOfTheSingularity) {
    double last_error = 1.0;
    for (const int angular : {2, 4, 8, 16}) {
        double sum = 0.0;
        for (const PlacedPoint& point : collapsed_rule(triangle, 2, angular)) {
            sum += point.weight / (point.x - triangle[0]).norm();
        }
        const double error = std::abs(sum - integral_of_inverse_distance(triangle));
        EXPECT_LT(error, 0.05 * last_error);
        last_error = std::max(error, 1e-14);
    }
    EXPECT_LT(last_error, 1e-10);
}

TEST(CollapsedRule, IntegratesSmoothAndHalfPowersTogether) {
    // r^(1/2) along rays: with u^(m/2) times a polynomial in t the rule is exact once it has enough points.
    const double area = triangle_area(triangle[0], triangle[1], triangle[2]);
    for (const int half_power : {-2, -1, 0, 1, 2, 3}) {
        double sum = 0.0, moment = 0.0;
        for (const PlacedPoint& point : collapsed_rule(triangle, 4, 3)) {
            const double u = 1.0 - triangle_area(point.x, triangle[1], triangle[2]) / area;
            const double t = triangle_area(triangle[0], triangle[1], point.x) / area / u;
            sum += point.weight * std::pow(u, 0.5 * half_power);
            moment += point.weight * std::pow(u, 0.5 * half_power) * t * t;
        }
        const double exact = 2.0 * area / (0.5 * half_power + 2.0);
        EXPECT_NEAR(sum, exact, 1e-13);
        EXPECT_NEAR(moment, exact / 3.0, 1e-13);
    }
}

}  // namespace
}  // namespace stria
