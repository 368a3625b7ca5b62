// Meshes with hanging nodes: patch tests, and the accuracy of a mesh that is fine everywhere.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iostream>
#include <tuple>

#include "coarse/model/mesh_refinement.hpp"
#include "common/error.hpp"
#include "tests/support/elastic_scene.hpp"
#include "tests/support/refined_squares.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

TEST(RefinedMesh, FillsTheBodyAndKeepsItsBoundary) {
    const Mesh mesh = refined_square(5, {0.45, 0.55}, 4);
    double area = 0.0;
    for (const auto& nodes : mesh.elements) {
        std::array<Vec2, 4> corners;
        for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh.nodes[at(nodes[k])];
        area += polygon_area(corners);
    }
    EXPECT_NEAR(area, 1.0, 1e-12);
    EXPECT_EQ(*std::ranges::max_element(mesh.level), 4);
    EXPECT_FALSE(mesh.hanging.empty());
    for (const auto& [name, edges] : mesh.boundary) {
        double length = 0.0;
        for (const BoundaryEdge& edge : edges) length += coarse::edge_geometry(mesh, edge).length();
        EXPECT_NEAR(length, 1.0, 1e-12) << name;
    }
}

TEST(RefinedMesh, NeighboursDifferByOneLevelAndEndsOfEdgesDoNotHang) {
    for (const double growth : {0.0, 0.1, 0.25}) {
        const Mesh mesh = refined_square(7, {0.31, 0.62}, 5, 0.1, growth);
        const IndexLists around = elements_around_nodes(mesh);
        for (std::size_t node = 0; node < around.size(); ++node) {
            const auto [least, most] =
                std::ranges::minmax(around[node], {}, [&](int element) { return mesh.level[at(element)]; });
            EXPECT_LE(mesh.level[at(most)] - mesh.level[at(least)], 1);
        }
        for (const HangingNode& hanging : mesh.hanging) {
            for (const int end : hanging.ends)
                EXPECT_FALSE(std::ranges::binary_search(mesh.hanging, end, {}, &HangingNode::node));
        }
    }
}

TEST(RefinedMesh, IsThatOfTheWholeBodyInADiskThatHoldsIt) {
    const Mesh mesh = refined_square(3, {0.5, 0.5}, 2, 10.0, 0.0);
    EXPECT_EQ(mesh.elements.size(), 9U * 16U);
    EXPECT_TRUE(mesh.hanging.empty());
}

void hold_boundary(coarse::Scene& scene) {
    const std::vector<int> nodes = boundary_nodes(scene.mesh);
    scene.prescribed.clear();
    for (const auto& [node, term, unknown] : scene.enriched.own_unknowns()) {
        if (!std::ranges::binary_search(nodes, node)) continue;
        for (const int component : {0, 1}) scene.prescribed.push_back({unknown + component, 0.0});
    }
}

/// A crack that grazes a node is snapped onto it: no longer straight, it bears some of the stress along it.
bool is_straight(const EnrichedMesh& mesh, const Vec2& through, const Vec2& along) {
    return std::ranges::all_of(mesh.pieces, [&](const CrackPiece& piece) {
        return std::ranges::all_of(piece.points,
                                   [&](const Vec2& x) { return std::abs(cross(along, x - through)) < 1e-12; });
    });
}

/// Largest force that the field of a homogeneous stress leaves at an unknown, of the largest terms that make it up.
double out_of_balance(coarse::Scene scene, const Eigen::Matrix2d& stress) {
    const Eigen::VectorXd u = linear_field(scene.enriched, gradient_of(stress, steel));
    hold_boundary(scene);
    const SparseMatrix K = coarse::Structure(scene).elements().stiffness();
    const Eigen::VectorXd scale = K.cwiseAbs() * u.cwiseAbs();
    return (K * u - scene.unit_force).cwiseAbs().maxCoeff() / scale.maxCoeff();
}

TEST(RefinedMesh, HomogeneousStressIsExact) {
    int straight = 0;
    for (int k = 0; k < 40; ++k) {
        const Vec2 tip(0.5 + 0.1 * std::sin(5.0 * k), 0.5 + 0.1 * std::cos(9.0 * k));
        const Vec2 along(std::cos(0.7 * k), std::sin(0.7 * k));
        const Mesh mesh =
            refined(k % 3 == 0 ? distorted(square_mesh(6), 0.02) : square_mesh(6), {{tip, tip, 0.15, 3, 0.2}}).mesh;
        const Eigen::Matrix2d stress = 100.0 * along * along.transpose();
        const std::vector<Vec2> crack{tip - 2.0 * along, k % 2 == 0 ? tip : Vec2(tip + 2.0 * along)};
        coarse::Scene scene = make_scene(mesh, cracked(mesh, crack, 6), steel, boundary_tractions(mesh, stress));
        if (!is_straight(scene.enriched, tip, along)) continue;
        ++straight;
        EXPECT_LT(out_of_balance(std::move(scene), stress), 1e-12) << k;
    }
    EXPECT_GE(straight, 36);
}

// Tip functions that no homogeneous stress moves: those of all nodes that see the tip are there, or none would add up.
TEST(RefinedMesh, HomogeneousStressIsExactWhereTipFunctionsCrossHangingNodes) {
    int across = 0;
    for (int k = 0; k < 60; ++k) {
        const AtTheRim rim(k);
        const Eigen::Matrix2d stress = 100.0 * rim.along * rim.along.transpose();
        coarse::Scene scene =
            make_scene(rim.mesh, cracked(rim.mesh, rim.crack, 6), steel, boundary_tractions(rim.mesh, stress));
        if (!is_straight(scene.enriched, rim.tip, rim.along)) continue;
        across += has_tip_function_that_hangs(scene.enriched) ? 1 : 0;
        EXPECT_LT(out_of_balance(std::move(scene), stress), 1e-12) << k;
    }
    EXPECT_GE(across, 20);
}

// The parts of a body cut in two move apart without force, those that meet along edges of which one side is split, too.
TEST(RefinedMesh, RigidHalvesPartFreely) {
    std::vector<std::tuple<Mesh, Vec2, Vec2>> bodies;  // with a place on the crack, and its direction
    for (int k = 0; k < 30; ++k) {
        const Vec2 centre(0.5 + 0.1 * std::sin(5.0 * k), 0.5 + 0.1 * std::cos(9.0 * k));
        bodies.emplace_back(refined_square(6, centre, 3, 0.15), centre, Vec2(std::cos(0.7 * k), std::sin(0.7 * k)));
    }
    for (const Vec2& split : {Vec2(0.5, 0.6), Vec2(0.5, 0.4), Vec2(0.6, 0.5), Vec2(0.4, 0.5)})
        for (const Vec2& along : {Vec2(1.0, 0.0), Vec2(-1.0, 0.0), Vec2(0.0, 1.0), Vec2(0.0, -1.0)})
            bodies.emplace_back(refined_square(6, split, 1, 0.04, 0.0), Vec2(0.5, 0.5), along);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const auto& [mesh, centre, along] = bodies[k];
        coarse::Scene scene = make_scene(mesh, cracked(mesh, {centre - 2.0 * along, centre + 2.0 * along}, 0), steel);
        const EnrichedMesh& enriched = scene.enriched;
        const auto rigid = [&](const Vec2& x) { return Vec2(0.3 - 0.7 * x.y(), -0.2 + 0.7 * x.x()); };
        Eigen::VectorXd u = Eigen::VectorXd::Zero(enriched.unknowns);
        for (const auto& [node, term, unknown] : enriched.own_unknowns()) {
            const Vec2& x = mesh.nodes[at(node)];
            double side = heaviside_side(enriched, node);
            if (side == 0.0) side = cross(along, x - centre) > 0.0 ? 1.0 : -1.0;
            u.segment<2>(unknown) = term == 0 ? (side > 0.0 ? rigid(x) : Vec2::Zero()) : Vec2(rigid(x) / 2.0);
        }
        hold_boundary(scene);
        const SparseMatrix K = coarse::Structure(scene).elements().stiffness();
        const Eigen::VectorXd scale = K.cwiseAbs() * u.cwiseAbs();
        EXPECT_LT((K * u).cwiseAbs().maxCoeff() / scale.maxCoeff(), 1e-12) << k;
    }
}

// A coarse mesh refined at the tip gives the K of a mesh as fine everywhere, with a fraction of the elements.
TEST(RefinedMesh, HasTheStressIntensityOfAUniformlyFineMesh) {
    const auto solve = [](int cells, int refine) {
        Case input = edge_crack(0.47, 4.0, End::Pulled);
        input.mesh.size = 1.0 / cells;
        input.fine.enrichment = Enrichment::Topological;
        input.fine.refine = refine;
        input.fine.radius = 0.3;
        return ElasticSolution(input);
    };
    const ElasticSolution fine = solve(160, 1), refined = solve(20, 8), coarse = solve(20, 1);
    const auto off = [&](const ElasticSolution& s) { return 100.0 * (s.tips[0].K_I / fine.tips[0].K_I - 1.0); };
    std::cout << fmt::format("elements {} / {} / {}: K_I off by {:+.3f} % refined, {:+.3f} % coarse\n",
                             fine.scene.mesh->elements.size(), refined.scene.mesh->elements.size(),
                             coarse.scene.mesh->elements.size(), off(refined), off(coarse));
    EXPECT_LT(std::abs(off(refined)), 0.2);
    EXPECT_LT(refined.scene.mesh->elements.size(), fine.scene.mesh->elements.size() / 10);
}

// A tip anywhere across the rim of small elements: K is as near as on large elements alone, or nearer.
TEST(RefinedMesh, HasTheStressIntensityWhereTipFunctionsCrossHangingNodes) {
    Case input = edge_crack(0.47, 4.0, End::Pulled);
    input.mesh.size = 1.0 / 160;
    input.fine.enrichment = Enrichment::Topological;
    const double K = ElasticSolution(input).tips[0].K_I;
    input.mesh.size = 1.0 / 40;
    const double of_large = std::abs(ElasticSolution(input).tips[0].K_I / K - 1.0);
    const Mesh body = coarse::refined_scene(input).mesh;
    double worst = 0.0;
    int across = 0;
    for (int k = 0; k < 12; ++k) {
        const Vec2 tip = input.cracks[0].points[1], beside = tip + Vec2(0.012 * (k - 6), 0.007 * (k % 5 - 2));
        const coarse::Scene scene =
            coarse::make_scene(input, BodyMesh(refined(body, {{beside, beside, 0.03, 1, 0.0}}).mesh));
        across += has_tip_function_that_hangs(scene.enriched) ? 1 : 0;
        worst = std::max(worst, std::abs(coarse::solve_nominal(scene).tips[0].K_I / K - 1.0));
    }
    std::cout << fmt::format("K_I off by {:.3f} % on large elements, at most {:.3f} % at the rim of small ones\n",
                             100.0 * of_large, 100.0 * worst);
    EXPECT_GE(across, 6);
    EXPECT_LT(worst, of_large + 0.001);
}

// A front that falls back by half of the larger edge that the crack runs along makes K 10 % smaller.
TEST(RefinedMesh, HasTheStressIntensityWithoutTipFunctionsAlongHalvesOfEdges) {
    Case input = edge_crack(0.47, 4.0, End::Pulled);
    input.fine.enrichment = Enrichment::Topological;
    input.mesh.size = 1.0 / 160;
    const double K = ElasticSolution(input).tips[0].K_I;
    input.fine.enrichment = Enrichment::None;
    input.mesh.size = 1.0 / 40;
    const Mesh body = coarse::refined_scene(input).mesh;
    double worst = 0.0;
    for (int k = 0; k < 60; k += 3) {
        const Vec2 beside = input.cracks[0].points[1] + Vec2(0.06 * std::sin(1.7 * k), 0.05 * std::cos(2.9 * k));
        const coarse::Scene scene = coarse::make_scene(
            input, BodyMesh(refined(body, {{beside, beside, 0.02 + 0.0007 * k, 1 + k % 2, 0.0}}).mesh));
        worst = std::max(worst, std::abs(coarse::solve_nominal(scene).tips[0].K_I / K - 1.0));
    }
    std::cout << fmt::format("K_I off by at most {:.3f} %\n", 100.0 * worst);
    EXPECT_LT(worst, 0.02);
}

}  // namespace
}  // namespace stria::test
