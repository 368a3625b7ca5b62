// Meshes with hanging nodes: continuous displacements on either side of a crack, patch tests, and the accuracy of a
// mesh that is fine everywhere.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iostream>
#include <map>
#include <numbers>
#include <random>
#include <tuple>

#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/model/mesh_refinement.hpp"
#include "common/error.hpp"
#include "common/fem/shape_q4.hpp"
#include "tests/support/elastic_scene.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

Mesh refined_square(int n, const Vec2& centre, int levels, double radius = 0.3, double growth = 0.2) {
    return coarse::refine(square_mesh(n), {{centre, centre, radius, levels, growth}}).mesh;
}

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

/// Displacement on one side of the crack, seen from one element.
Vec2 displacement(const EnrichedMesh& mesh, int element, const Vec2& x, int side, const Eigen::VectorXd& u) {
    const ElementBasis basis(mesh, element, piece_in(mesh, element) != nullptr);
    BasisValues values;
    basis.evaluate(map_to_parent(basis.corners(), x), x, side, values);
    Vec2 sum = Vec2::Zero();
    for (int f = 0; f < basis.functions(); ++f) sum += values.value[f] * u.segment<2>(basis.unknowns()[at(2 * f)]);
    return sum;
}

/// Crack side of an element at a point of its boundary off the crack.
int side_in(const EnrichedMesh& mesh, int element, const Vec2& x) {
    const CrackPiece* piece = piece_in(mesh, element);
    if (piece == nullptr) return mesh.element_side[at(element)];
    const auto c = corners_of_element(mesh, element);
    return cut_element(c, *piece).side_of(x + 1e-9 * ((c[0] + c[1] + c[2] + c[3]) / 4.0 - x));
}

/// Largest difference between the traces of a larger and a smaller element on the edges with hanging nodes. Halves of
/// edges that are themselves part of the crack are left out: there it may jump.
double discontinuity(const Mesh& mesh, const EnrichedMesh& enriched) {
    const Eigen::VectorXd u = Eigen::VectorXd::Random(enriched.unknowns);
    const auto around = elements_around_nodes(mesh);
    double largest = 0.0;
    for (const HangingNode& hanging : mesh.hanging) {
        for (const int end : hanging.ends) {
            const Vec2 &a = mesh.nodes[at(hanging.node)], &b = mesh.nodes[at(end)];
            const auto smaller = std::ranges::find_if(around[at(hanging.node)], [&](int element) {
                return std::ranges::find(mesh.elements[at(element)], end) != mesh.elements[at(element)].end();
            });
            for (const double t : {0.003, 0.13, 0.37, 0.61, 0.89, 0.997}) {
                const Vec2 x = a + t * (b - a);
                const int side = side_in(enriched, *smaller, x), other = side_in(enriched, hanging.larger, x);
                if (side * other < 0) continue;
                const Vec2 jump =
                    displacement(enriched, *smaller, x, side, u) - displacement(enriched, hanging.larger, x, other, u);
                largest = std::max(largest, jump.norm());
            }
        }
    }
    return largest;
}

TEST(RefinedMesh, DisplacementsAreContinuousWhereverTheCrackCrosses) {
    for (int k = 0; k < 60; ++k) {
        const Vec2 centre(0.5 + 0.1 * std::sin(5.0 * k), 0.5 + 0.1 * std::cos(9.0 * k));
        const Vec2 along(std::cos(0.7 * k), std::sin(0.7 * k));
        const Mesh mesh = refined_square(6, centre, 3, 0.15);
        const bool with_tip = k % 2 == 0;
        const Vec2 end = with_tip ? centre : Vec2(centre + 2.0 * along);
        EXPECT_LT(discontinuity(mesh, cracked(mesh, {centre - 2.0 * along, end}, with_tip ? 6 : 0)), 1e-12) << k;
    }
}

TEST(RefinedMesh, DisplacementsAreContinuousWhereTheCrackMeetsNodes) {
    const Mesh mesh = refined_square(4, {0.5, 0.5}, 3, 0.2);
    for (const auto& [from, to] :
         std::vector<std::pair<Vec2, Vec2>>{{{0.0, 0.5}, {1.0, 0.5}},      // along edges
                                            {{0.0, 0.0}, {1.0, 1.0}},      // through nodes
                                            {{0.0, 0.625}, {1.0, 0.625}},  // through hanging ones
                                            {{0.0, 0.5}, {0.5, 0.5}},
                                            {{0.0, 0.375}, {1.0, 0.875}},
                                            {{0.125, 0.0}, {0.625, 1.0}},
                                            {{0.6875, 0.0}, {0.6875, 1.0}}}) {
        EXPECT_LT(discontinuity(mesh, cracked(mesh, {from, to}, 6)), 1e-12) << from.transpose() << to.transpose();
    }
}

/// Cracks whose tips lie where small elements end, as those of a crack that has grown into metal that has flowed.
struct AtTheRim {
    Mesh mesh;
    Vec2 tip, along;
    std::vector<Vec2> crack;

    explicit AtTheRim(int k, bool bent = false) {
        const Vec2 centre(0.5 + 0.1 * std::sin(5.0 * k), 0.5 + 0.1 * std::cos(9.0 * k));
        mesh = coarse::refine(k % 3 == 0 ? distorted(square_mesh(6), 0.02) : square_mesh(6),
                              {{centre, centre, 0.15, 3, 0.2}})
                   .mesh;
        tip = centre + (0.05 + 0.004 * k) * Vec2(std::cos(2.3 * k), std::sin(2.3 * k));
        along = {std::cos(0.7 * k), std::sin(0.7 * k)};
        const Vec2 aside(-along.y(), along.x());
        crack = {tip - 2.0 * along, tip};
        if (bent) crack.insert(crack.begin() + 1, tip - 0.1 * along + 0.05 * aside);
    }
};

bool has_tip_function_that_hangs(const EnrichedMesh& enriched) {
    return std::ranges::any_of(enriched.tied, [&](const TiedNode& tied) {
        const std::vector<Term>& terms = enriched.terms[at(tied.node)];
        return std::ranges::find(terms, Term::Kind::Tip, &Term::kind) != terms.end();
    });
}

TEST(RefinedMesh, TipFunctionsAreContinuousAcrossHangingNodes) {
    int across = 0;
    for (int k = 0; k < 60; ++k) {
        const AtTheRim rim(k, k % 2 == 1);
        const EnrichedMesh enriched = cracked(rim.mesh, rim.crack, 6);
        across += has_tip_function_that_hangs(enriched) ? 1 : 0;
        EXPECT_LT(discontinuity(rim.mesh, enriched), 1e-12) << k;
    }
    EXPECT_GE(across, 20);
}

/// Cracks that bend anywhere or at nodes and middles of edges, in elements of up to four sizes; those that the mesh
/// cannot hold have no unknowns.
EnrichedMesh anywhere(int k, Mesh& mesh) {
    std::mt19937 random(7919U * static_cast<unsigned>(k) + 13U);
    const auto real = [&](double a, double b) { return std::uniform_real_distribution<>(a, b)(random); };
    const auto whole = [&](int a, int b) { return std::uniform_int_distribution<>(a, b)(random); };
    const int n = whole(4, 8), parts = std::array{0, 1, 2, 4, 8}[at(whole(0, 4))];
    std::vector<coarse::RefinedDisk> disks;
    for (int left = whole(1, 3); left > 0; --left) {
        const Vec2 centre(real(0.2, 0.8), real(0.2, 0.8));
        disks.push_back({centre, centre, real(0.02, 0.2), whole(1, 3), real(0.0, 0.25)});
    }
    mesh = coarse::refine(whole(0, 3) == 0 ? distorted(square_mesh(n), 0.1 / n) : square_mesh(n), disks).mesh;
    const auto put = [&](double x) { return parts > 0 ? std::round(x * n * parts) / (n * parts) : x; };
    std::vector<Vec2> points{{put(real(0.2, 0.8)), 0.0}};
    double angle = std::numbers::pi / 2.0 + (whole(0, 1) == 0 ? 0.0 : real(-0.7, 0.7));
    for (int left = whole(1, 3); left > 0; --left) {
        const Vec2 next = points.back() + real(0.1, 0.4) * Vec2(std::cos(angle), std::sin(angle));
        points.emplace_back(put(next.x()), put(next.y()));
        angle += whole(0, 2) == 0 ? std::copysign(std::numbers::pi / 2.0, real(-1.0, 1.0)) : real(-1.5, 1.5);
    }
    try {
        return cracked(mesh, points, std::array{0, 1, 6}[at(whole(0, 2))]);
    } catch (const CaseError&) {
        return {};
    }
}

TEST(RefinedMesh, DisplacementsAreContinuousWhereverElementsOfTwoSizesMeet) {
    int held = 0;
    Mesh mesh;
    for (int k = 0; k < 2000; ++k) {
        const EnrichedMesh enriched = anywhere(k, mesh);
        if (enriched.unknowns == 0) continue;
        ++held;
        EXPECT_LT(discontinuity(mesh, enriched), 1e-12) << k;
    }
    EXPECT_GE(held, 1700);
}

// The line behind a tip beyond a right angle runs through elements that lie on one side of the crack.
TEST(RefinedMesh, TipFunctionsAreContinuousBehindARightAngle) {
    constexpr double h = 1.0 / 48.0;
    for (const int levels : {2, 3}) {
        const Mesh mesh = refined_square(6, {0.43, 0.56}, levels, 0.08);
        for (const double x : {24.0 * h, 32.0 * h}) {
            const Vec2 tip(x, 20.0 * h), corner(x - 8.0 * h, 20.0 * h);
            EXPECT_LT(discontinuity(mesh, cracked(mesh, {{corner.x(), 0.0}, corner, tip}, 6)), 1e-12) << x;
        }
    }
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
            coarse::refine(k % 3 == 0 ? distorted(square_mesh(6), 0.02) : square_mesh(6), {{tip, tip, 0.15, 3, 0.2}})
                .mesh;
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
                             fine.scene.mesh.elements.size(), refined.scene.mesh.elements.size(),
                             coarse.scene.mesh.elements.size(), off(refined), off(coarse));
    EXPECT_LT(std::abs(off(refined)), 0.2);
    EXPECT_LT(refined.scene.mesh.elements.size(), fine.scene.mesh.elements.size() / 10);
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
            coarse::make_scene(input, coarse::refine(body, {{beside, beside, 0.03, 1, 0.0}}).mesh);
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
        const coarse::Scene scene =
            coarse::make_scene(input, coarse::refine(body, {{beside, beside, 0.02 + 0.0007 * k, 1 + k % 2, 0.0}}).mesh);
        worst = std::max(worst, std::abs(coarse::solve_nominal(scene).tips[0].K_I / K - 1.0));
    }
    std::cout << fmt::format("K_I off by at most {:.3f} %\n", 100.0 * worst);
    EXPECT_LT(worst, 0.02);
}

}  // namespace
}  // namespace stria::test
