// T stress by the interaction integral with a point force: exact fields and cracks in a nearly infinite plate.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iostream>
#include <numbers>

#include "common/geometry/vec2.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/elastic_scene.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

using std::numbers::pi;

/// Holds the boundary of a square at K_I = 1, T = 1 about the tip of a crack from its left side to its middle.
void impose_K_and_T(coarse::Scene& scene) {
    const EnrichedMesh& mesh = scene.enriched;
    const Tip& tip = mesh.tips.front();
    const Eigen::Matrix2d stretch = gradient_of(Vec2(1.0, 0.0).asDiagonal(), scene.materials.elastic(0));
    for (const int node : boundary_nodes(scene.mesh)) {
        const Vec2& x = mesh.nodes[at(node)];
        const Vec2 u =
            williams_field(1, tip, x, 0, scene.materials.elastic(0)).displacement + stretch * (x - tip.position);
        for (int c = 0; c < 2; ++c) scene.prescribed.push_back({mesh.unknown(node, 0, c), u[c]});
        if (heaviside_side(mesh, node) == 0.0) continue;
        const Vec2& mouth = mesh.pieces.front().points.front();
        const double opening = williams_field(1, tip, mouth, 1, scene.materials.elastic(0)).displacement.y();
        scene.prescribed.push_back({mesh.unknown(node, 1, 0), 0.0});
        scene.prescribed.push_back({mesh.unknown(node, 1, 1), opening});
    }
    std::ranges::sort(scene.prescribed, {}, &coarse::PrescribedUnknown::unknown);
}

TEST(TStress, ConvergesToTheExactFields) {
    for (const PlaneState plane : {PlaneState::Strain, PlaneState::Stress}) {
        std::vector<double> errors;
        for (const int n : {11, 21, 41, 81}) {
            const Mesh mesh = square_mesh(n);
            const std::vector<Vec2> crack{{0.0, 0.5}, {0.5, 0.5}};
            coarse::Scene scene = make_scene(mesh, cracked(mesh, crack), {1.0, 0.3, plane});
            scene.input.cracks = {{.points = crack, .contact = {}}};
            impose_K_and_T(scene);
            const coarse::Structure structure(scene);
            const coarse::TipResult tip = coarse::fracture_parameters(structure, structure.expand({}, 1.0), {}).front();
            errors.push_back(std::abs(tip.T_stress - 1.0));
            std::cout << fmt::format("plane {} n {:2d}: T {:.4f}, K_I {:.4f}, spread of K {:.2e}, of J {:.2e}\n",
                                     plane == PlaneState::Strain ? "strain" : "stress", n, tip.T_stress, tip.K_I,
                                     tip.K_spread, tip.J_spread);
        }
        EXPECT_LT(errors[3], 0.005);
        EXPECT_LT(errors[3], 0.6 * errors[2]);
    }
}

// In an infinite plate T = sigma cos 2 beta: along the crack the remote stress is sigma cos^2 beta; the stress normal
// to it, sigma sin^2 beta, is taken off the faces, and with it as much of the stress along the crack. Shear gives none.
TEST(TStress, OfAnInclinedCrackInAnInfinitePlate) {
    for (const double degrees : {30.0, 45.0, 60.0, 90.0}) {  // between the crack and the load
        const double beta = degrees * pi / 180.0, a = 0.05;
        const Vec2 centre(0.5, 0.5), half = a * Vec2(std::sin(beta), std::cos(beta));
        Case input = specimen("plate", 1.0, {centre - half, centre + half});
        input.mesh.size = 1.0 / 25.0;
        input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
        input.mesh.grading = {{.at = {centre}, .size = a / 25.0, .outer_size = {}, .radius = 1.5 * a}};
        const ElasticSolution solution(input);
        for (const coarse::TipResult& tip : solution.tips) {
            std::cout << fmt::format("beta {}: T {:+.4f} sigma, exact {:+.4f}; spread of K {:.2e}, of J {:.2e}\n",
                                     degrees, tip.T_stress, std::cos(2.0 * beta), tip.K_spread, tip.J_spread);
            verify({.scene = fmt::format("T stress, crack at {} degrees", degrees),
                    .source = "infinite plate, closed form",
                    .quantity = "T / sigma",
                    .reference = std::cos(2.0 * beta),
                    .ours = tip.T_stress,
                    .within = 0.02,
                    .mesh = "a / 25",
                    .scale = 1.0});
        }
    }
}

TEST(TStress, OfSpecimens) {
    const auto biaxiality = [](const std::string& name, const Case& input) {
        const coarse::TipResult tip = ElasticSolution(graded_to_tips(input)).tips[0];
        const double ratio = tip.T_stress * std::sqrt(pi * tip.a) / tip.K_I;
        std::cout << fmt::format("{:14s} T {:+.4f}, T sqrt(pi a) / K_I {:+.4f}\n", name, tip.T_stress, ratio);
        return ratio;
    };
    // A short edge crack: that of a half-plane, T = -0.526 sigma with K_I = 1.1215 sigma sqrt(pi a).
    EXPECT_NEAR(biaxiality("sent a/W 0.1", edge_crack(0.1, 4.0, End::Pulled)), -0.469, 0.03);
    for (const double x : {0.3, 0.5, 0.7}) biaxiality(fmt::format("sent a/W {}", x), edge_crack(x, 4.0, End::Pulled));
    for (const double x : {0.3, 0.5, 0.7}) biaxiality(fmt::format("ct a/W {}", x), compact_tension(x));
    EXPECT_NEAR(biaxiality("mt 2a/W 0.1", middle_crack(0.1, 3.0)), -1.0, 0.02);
    EXPECT_LT(biaxiality("sent a/W 0.3", edge_crack(0.3, 4.0, End::Pulled)), 0.0);
    EXPECT_GT(biaxiality("ct a/W 0.5", compact_tension(0.5)), 0.0);
}

}  // namespace
}  // namespace stria::test
