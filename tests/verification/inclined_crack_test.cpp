// Inclined centre crack (docs/references.md 2.4) in plates so wide that they are nearly infinite, on at most 41
// elements across.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iostream>
#include <numbers>

#include "coarse/growth/crack_advance.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

using std::numbers::pi;

/// Crack of half length 1 in the middle of a square plate, `degrees` to the load; `halved`: every element.
Case inclined_crack(double width, double degrees, bool halved) {
    const double beta = degrees * pi / 180.0, h = halved ? 0.05 : 0.1;
    const Vec2 centre(width / 2.0, width / 2.0), half(std::sin(beta), std::cos(beta));
    Case input = specimen("plate", width, {centre - half, centre + half});
    input.mesh.width = width;
    input.mesh.size = 1.25 * width * h;
    input.mesh.grading = {{.at = {centre}, .size = h, .outer_size = h, .radius = 0.8, .growth = 4.0 * h}};
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    return input;
}

/// Of the infinite plate, percent.
struct Excess {
    double K_I, K_II, by_J;
    int across;  // elements
};

Excess inclined_excess(double width, double degrees, bool halved) {
    const double beta = degrees * pi / 180.0, s = std::sin(beta), c = std::cos(beta);
    const ElasticSolution solution(inclined_crack(width, degrees, halved));
    if (!halved) {
        EXPECT_LE(solution.elements_across(), 41);
    }
    const coarse::TipResult &one = solution.tips[0], &other = solution.tips[1];
    EXPECT_NEAR(one.K_I, other.K_I, 1e-3 * one.K_I);
    EXPECT_NEAR(one.K_II, other.K_II, 1e-3 * one.K_I);
    const Excess excess{100.0 * (one.K_I / (s * s * std::sqrt(pi)) - 1.0),
                        100.0 * (std::abs(one.K_II) / (s * c * std::sqrt(pi)) - 1.0),
                        100.0 * (std::sqrt(one.J * plane_modulus / pi) / s - 1.0), solution.elements_across()};
    std::cout << fmt::format(
        "inclined {} degrees, a/W {:.4f}, {} across: K_I {:+.3f} %, K_II {:+.3f} %, by J {:+.3f} %\n", degrees,
        1.0 / width, solution.elements_across(), excess.K_I, excess.K_II, excess.by_J);
    return excess;
}

// Pure mode II, and the directions of cracks at these angles to the load.
TEST(InclinedCrack, TurnsToTheLargestHoopStress) {
    const auto row = [](const std::string& scene, double degrees, double K_I, double K_II) {
        verify({.scene = scene,
                .source = "Erdogan, Sih 1963 (2.4)",
                .quantity = "direction of growth, degrees",
                .reference = degrees,
                .ours = coarse::hoop_stress_angle(K_I, K_II) * 180.0 / pi,
                .within = 1e-4 / std::abs(degrees)});
    };
    row("pure mode II", -70.5288, 0.0, 1.0);
    for (const auto& [degrees, turn] : {std::pair{30.0, -60.0}, {45.0, -53.1301}, {60.0, -43.2213}}) {
        const double beta = degrees * pi / 180.0;
        row(fmt::format("crack at {} degrees to the load", degrees), turn, std::sin(beta), std::cos(beta));
    }
}

// What the plate adds falls with (a/W)^2: it is that of halved elements in a plate of half the width, over 4.
TEST(InclinedCrack, MatchesTheInfinitePlate) {
    for (const double degrees : {30.0, 45.0, 60.0}) {
        const Excess narrow = inclined_excess(20.0, degrees, true), fine = inclined_excess(40.0, degrees, true),
                     own = inclined_excess(40.0, degrees, false);
        EXPECT_LT(std::abs(fine.K_I - narrow.K_I / 4.0), 0.1);
        EXPECT_LT(std::abs(fine.K_II - narrow.K_II / 4.0), 0.1);
        for (const double off : {own.by_J, own.K_I - narrow.K_I / 4.0, own.K_II - narrow.K_II / 4.0})
            EXPECT_LT(std::abs(off), 0.3);
        const double beta = degrees * pi / 180.0, s = std::sin(beta), c = std::cos(beta);
        for (const auto& [quantity, exact, off] :
             {std::tuple("K_I / (sigma sqrt(pi a))", s * s, own.K_I), {"K_II / (sigma sqrt(pi a))", s * c, own.K_II}})
            verify({.scene = fmt::format("inclined crack, {} degrees, plate of 40 a", degrees),
                    .source = "infinite plate, closed form (2.4)",
                    .quantity = quantity,
                    .reference = exact,
                    .ours = exact * (1.0 + 0.01 * off),
                    .within = 0.003,
                    .mesh = fmt::format("{} across", own.across)});
    }
}

}  // namespace
}  // namespace stria::test
