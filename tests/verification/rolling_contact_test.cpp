// Pressures that travel along an edge: their statics, the stresses below them, and an inclined crack under a wheel.
#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <iostream>
#include <numbers>

#include "tests/support/load_cases.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

constexpr double p0 = 100.0, half_width = 1.0, block_width = 2000.0, block_height = 1000.0,
                 block_middle = 0.5 * block_width;

/// A body that stands for a half plane, under a wheel that rolls over the middle of its top.
Case below_wheel(const TravellingPressure& wheel, int steps) {
    Case input = specimen("plate", block_height, {});
    input.cracks.clear();
    input.mesh.width = block_width;
    input.mesh.size = 100.0;
    input.load = {.steps = steps, .grading = 1.0, .blocks = {{.cycles = 1, .max = 0.0, .min = -1.0}}};
    input.boundaries = {held("bottom"), under_wheel("top", wheel, {block_middle, block_height})};
    return input;
}

TravellingPressure wheel(double friction = 0.0) {
    return {.p0 = p0, .half_width = half_width, .friction = friction, .from = -8.0, .to = 8.0};
}

// At every position, with a crack's mouth below the path and elements that the ends of the pressure cut anywhere.
TEST(RollingContact, ForceAndMomentAreThoseOfTheWheelEverywhere) {
    Case input = below_wheel(wheel(0.2), 38);
    input.mesh.grading = {
        {.at = {{block_middle, block_height}}, .size = 0.3, .outer_size = 0.3, .radius = 2.0, .growth = 0.3}};
    input.cracks = {
        {.points = {{block_middle + 0.013, block_height}, {block_middle + 1.0, block_height - 1.0}}, .contact = {}}};
    const coarse::Scene scene = coarse::refined_scene(input);
    ASSERT_EQ(scene.case_forces.size(), 39U);
    const double P = 0.5 * std::numbers::pi * p0 * half_width;
    for (std::size_t k = 0; k < scene.case_forces.size(); ++k) {
        Vec2 force = Vec2::Zero();
        double moment = 0.0;
        for (const auto& [node, term, unknown] : scene.enriched.own_unknowns()) {
            if (term != 0) continue;
            const Vec2 f = scene.case_forces[k].segment<2>(unknown), &x = scene.enriched.nodes[at(node)];
            force += f;
            moment += cross(x, f);
        }
        const double at_x = block_middle - 8.0 + 16.0 * static_cast<double>(k) / 38.0;
        EXPECT_NEAR(force.y(), -P, 1e-10 * P) << k;
        EXPECT_NEAR(force.x(), 0.2 * P, 1e-10 * P) << k;
        EXPECT_NEAR(moment, -P * at_x - 0.2 * P * block_height, 1e-10 * P * block_width) << k;
    }
}

/// Johnson, Contact Mechanics (1985), eq. (4.49): stresses in a half plane below a line contact, x along it, z into it.
struct BelowHertz {
    double xx, zz, xz;
    BelowHertz(double x, double z) {
        const double sum = half_width * half_width - x * x + z * z, root = std::hypot(sum, 2.0 * x * z);
        const double m = std::sqrt(0.5 * (root + sum)), n = std::copysign(std::sqrt(0.5 * (root - sum)), x);
        const double share = (z * z + n * n) / (m * m + n * n);
        xx = -p0 / half_width * (m * (1.0 + share) - 2.0 * z);
        zz = -p0 / half_width * m * (1.0 - share);
        xz = p0 / half_width * n * (m * m - z * z) / (m * m + n * n);
    }
};

TEST(RollingContact, StressesBelowAreThoseOfAHalfPlane) {
    Case input = below_wheel(wheel(), 4);
    input.mesh.grading = {
        {.at = {{block_middle, block_height}}, .size = 0.05, .outer_size = 0.05, .radius = 2.5, .growth = 0.25}};
    const coarse::Scene scene = coarse::refined_scene(input);
    const coarse::Structure structure(scene);
    const Eigen::VectorXd u = structure.expand({}, coarse::LoadFactors::of_one_case(2));  // in the middle
    double worst = 0.0;
    structure.elements().for_each([&](const auto& op) {
        Mandel strain = Mandel::Zero();
        Vec2 centre = Vec2::Zero();
        const auto local = gather(u, op.unknowns);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            strain += op.strain(local, q) / static_cast<double>(op.points.size());
            centre += op.points[q].x / static_cast<double>(op.points.size());
        }
        const double x = centre.x() - block_middle, z = block_height - centre.y();
        if (std::hypot(x, z) > 2.0 || z < 0.1) return;
        const Mandel stress = scene.stiffness(op.element) * strain;
        const BelowHertz exact(x, z);
        worst = std::max({worst, std::abs(stress[0] - exact.xx), std::abs(stress[1] - exact.zz),
                          std::abs(stress[3] / std::sqrt(2.0) - exact.xz)});
    });
    std::cout << fmt::format("stresses below a wheel: off by {:.3f} % of p0 at most\n", 100.0 * worst / p0);
    EXPECT_LT(worst, 0.01 * p0);
}

/// Largest and smallest K_II in the third pass, in p0 sqrt(half width), and where the wheel is then.
struct Peaks {
    double most = -1e300, least = 1e300, at_most = 0.0, at_least = 0.0, K_I = -1e300;
};

Peaks peaks_of(double friction, double size, int steps) {
    Case input = below_wheel(wheel(), steps);
    input.load.blocks = {{.cycles = 3, .max = 0.0, .min = -1.0}};
    const Vec2 mouth(block_middle, block_height),
        down(std::cos(std::numbers::pi / 6.0), -std::sin(std::numbers::pi / 6.0));
    input.cracks = {{.points = {mouth, mouth + half_width * down}, .contact = ContactSection{friction}}};
    input.mesh.grading = {
        {.at = {mouth + 0.5 * half_width * down}, .size = size, .outer_size = size, .radius = 0.8, .growth = 0.25}};
    Peaks peaks;
    for (const coarse::Increment& increment : run_direct(input).increments) {
        if (increment.step.cycle != 3) continue;
        Eigen::Index position = 0;
        increment.step.target.cases.maxCoeff(&position);
        const double at = wheel().from + (wheel().to - wheel().from) * static_cast<double>(position) / steps;
        const double K = increment.tips[0].K_II / (p0 * std::sqrt(half_width));
        if (K > peaks.most) peaks.most = K, peaks.at_most = at;
        if (K < peaks.least) peaks.least = K, peaks.at_least = at;
        peaks.K_I = std::max(peaks.K_I, increment.tips[0].K_I / (p0 * std::sqrt(half_width)));
    }
    std::cout << fmt::format("friction {:.1f}: K_II {:+.4f} @{:.2f}, {:+.4f} @{:.2f}, range {:.4f}; K_I {:.4f}\n",
                             friction, peaks.most, peaks.at_most, peaks.least, peaks.at_least, peaks.most - peaks.least,
                             peaks.K_I);
    return peaks;
}

// docs/references.md 8.5: at 30 degrees to the surface, as long as the contact is half wide.
TEST(RollingContact, AnInclinedCrackSlidesToAndFroAsFrictionLetsItLong) {
    struct Row {
        double friction, one, other;
    };
    for (const auto& [friction, one, other] :
         {Row{0.0, 0.3748, 0.1905}, {0.1, 0.2706, 0.1634}, {0.2, 0.1767, 0.1280}, {0.3, 0.1156, 0.0979}}) {
        const Peaks peaks = peaks_of(friction, 0.025, 96);
        const double larger = std::max(peaks.most, -peaks.least), smaller = std::min(peaks.most, -peaks.least);
        EXPECT_NEAR(larger, one, 0.03 * one) << friction;
        EXPECT_NEAR(smaller, other, 0.03 * other) << friction;
        EXPECT_NEAR(larger + smaller, one + other, 0.015 * (one + other)) << friction;
        EXPECT_LT(peaks.K_I, 0.03) << friction;
    }
}

}  // namespace
}  // namespace stria::test
