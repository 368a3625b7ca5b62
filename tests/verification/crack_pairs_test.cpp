// Stress intensities of cracks that lie beside each other.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "coarse/specimen/handbook.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

using std::numbers::pi;

/// Exact for an infinite plate: cracks from b to c and from -c to -b (Westergaard's function of two collinear cracks).
struct Collinear {
    double inner, outer;  // K / stress
};

Collinear two_collinear(double b, double c) {
    const double k = std::sqrt(1.0 - b * b / (c * c));
    const double middle = c * c * std::comp_ellint_2(k) / std::comp_ellint_1(k), span = std::sqrt(c * c - b * b);
    return {std::sqrt(pi / b) * (middle - b * b) / span, std::sqrt(pi / c) * (c * c - middle) / span};
}

TEST(Specimens, TwoCollinearCracksPullAtEachOther) {
    const double b = 0.2, c = 1.0, width = 20.0;
    Case input = specimen("plate", width, {{width / 2.0 - c, width / 2.0}, {width / 2.0 - b, width / 2.0}});
    input.mesh.width = width;
    input.cracks.push_back({.points = {{width / 2.0 + b, width / 2.0}, {width / 2.0 + c, width / 2.0}}, .contact = {}});
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    const ElasticSolution solution(graded_to_tips(input, 0.03));
    ASSERT_EQ(solution.tips.size(), 4U);
    const Collinear exact = two_collinear(b, c);
    const double finite_plate = coarse::mt_factor(2.0 * c / width);
    const std::array<double, 4> expected{exact.outer, exact.inner, exact.inner, exact.outer};
    for (std::size_t t = 0; t < 4; ++t) {
        const coarse::TipResult& tip = solution.tips[t];
        EXPECT_NEAR(tip.a, (c - b) / 2.0, 1e-12);
        const double K = expected[t] * finite_plate, by_J = std::sqrt(tip.J * plane_modulus);
        std::cout << fmt::format("collinear tip {}: K_I {:+.2f} %, by J {:+.2f} %\n", t, 100.0 * (tip.K_I / K - 1.0),
                                 100.0 * (by_J / K - 1.0));
        EXPECT_NEAR(tip.K_I, K, 0.01 * expected[t]);
        EXPECT_NEAR(by_J, K, 0.01 * expected[t]);
    }
}

TEST(Specimens, TwoParallelCracksShieldEachOther) {
    const double a = 1.0, width = 20.0;
    const auto level = [&](double y) {
        return std::vector<Vec2>{{width / 2.0 - a, width / 2.0 + y}, {width / 2.0 + a, width / 2.0 + y}};
    };
    const auto solve = [&](std::vector<double> heights) {
        Case input = specimen("plate", width, level(heights[0]));
        input.mesh.width = width;
        for (std::size_t k = 1; k < heights.size(); ++k)
            input.cracks.push_back({.points = level(heights[k]), .contact = {}});
        input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
        return ElasticSolution(graded_to_tips(input, 0.05)).tips;
    };
    const auto one = solve({0.0}), two = solve({-0.5, 0.5});
    ASSERT_EQ(two.size(), 4U);
    for (const coarse::TipResult& tip : two) {
        std::cout << fmt::format("parallel: K_I {:.4f} of alone, K_II {:+.4f}\n", tip.K_I / one[0].K_I,
                                 tip.K_II / one[0].K_I);
        EXPECT_NEAR(tip.K_I, two[0].K_I, 1e-3 * two[0].K_I);
        EXPECT_NEAR(std::abs(tip.K_II), std::abs(two[0].K_II), 1e-3 * two[0].K_I);
        EXPECT_LT(tip.K_I, 0.9 * one[0].K_I);
        EXPECT_NEAR(tip.J * plane_modulus, tip.K_I * tip.K_I + tip.K_II * tip.K_II, 0.01 * tip.K_I * tip.K_I);
    }
    EXPECT_LT(two[0].K_II * two[2].K_II, 0.0);
    EXPECT_LT(two[0].K_II * two[1].K_II, 0.0);
}

}  // namespace
}  // namespace stria::test
