// Patch tests: homogeneous stress is exact in uncut, cut and tip elements, and a body cut in two moves apart without
// force.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "coarse/mesh_file/mesh_file.hpp"
#include "common/enrichment/part_of_mesh.hpp"
#include "tests/support/elastic_scene.hpp"
#include "tests/support/mesh_files.hpp"

namespace stria::test {
namespace {

constexpr double rounding = 1e-12;

const std::vector<double> graded_lines{0.0, 0.4, 0.6, 0.68, 0.72, 0.8, 1.0};

/// Prescribes every unknown of the boundary's nodes, jumps included.
void hold_boundary(coarse::Scene& scene, const Eigen::VectorXd& u) {
    scene.prescribed.clear();
    for (const int node : boundary_nodes(scene.mesh)) {
        const int first = scene.enriched.unknown(node, 0, 0);
        for (int k = 0; k < 2 * (1 + static_cast<int>(scene.enriched.terms[at(node)].size())); ++k) {
            scene.prescribed.push_back({first + k, u[first + k]});
        }
    }
}

/// Largest force out of balance with a displacement, relative to the largest that its parts could make.
double imbalance(coarse::Scene& scene, const Eigen::VectorXd& u) {
    hold_boundary(scene, u);
    const SparseMatrix K = coarse::Structure(scene).elements().stiffness();
    const Eigen::VectorXd scale = K.cwiseAbs() * u.cwiseAbs();
    return (K * u - scene.unit_force).cwiseAbs().maxCoeff() / scale.maxCoeff();
}

TEST(PatchTest, UncutElementsOfAnyShape) {
    const Eigen::Matrix2d gradient{{1e-3, -4e-4}, {7e-4, 2e-3}};
    for (Mesh mesh :
         {coarse::grid_mesh(graded_lines, graded_lines),
          distorted(coarse::grid_mesh(graded_lines, graded_lines), 0.009), distorted(square_mesh(6), 0.04)}) {
        coarse::Scene scene = make_scene(mesh, coarse::enrich(BodyMesh(mesh), {}, {}), steel);
        const Eigen::VectorXd u = linear_field(scene.enriched, gradient);
        hold_boundary(scene, u);
        const Eigen::VectorXd found = coarse::Structure(scene).expand({}, 1.0);
        EXPECT_LT((found - u).cwiseAbs().maxCoeff(), rounding * u.cwiseAbs().maxCoeff());
    }
}

/// A straight crack and the uniaxial stress along it that leaves its faces free: every unknown is in balance with the
/// tractions on the boundary, those of jumps and tip functions included.
double imbalance_of_tension_along(const Mesh& mesh, const Vec2& from, const Vec2& to, int tip_functions,
                                  double exponent = 0.5) {
    const Vec2 along = (to - from).normalized();
    const Eigen::Matrix2d stress = 100.0 * along * along.transpose();
    coarse::Scene scene =
        make_scene(mesh, cracked(mesh, {from, to}, tip_functions, exponent), steel, boundary_tractions(mesh, stress));
    return imbalance(scene, linear_field(scene.enriched, gradient_of(stress, steel)));
}

TEST(PatchTest, CutThroughAtManyPositionsAndAngles) {
    for (int k = 0; k < 60; ++k) {
        const Mesh mesh = k % 2 == 0 ? square_mesh(5) : distorted(square_mesh(5), 0.03);
        const Vec2 centre(0.5 + 0.2 * std::sin(5.0 * k), 0.5 + 0.2 * std::cos(9.0 * k));
        const Vec2 along(std::cos(0.7 * k), std::sin(0.7 * k));
        EXPECT_LT(imbalance_of_tension_along(mesh, centre - 2.0 * along, centre + 2.0 * along, 6), rounding) << k;
    }
}

TEST(PatchTest, CutThroughNodesAndAlongEdges) {
    const Mesh mesh = square_mesh(4);
    for (const auto& [from, to] : std::vector<std::pair<Vec2, Vec2>>{{{0.0, 0.0}, {1.0, 1.0}},
                                                                     {{0.0, 0.5}, {1.0, 0.5}},
                                                                     {{0.25, 0.0}, {0.25, 1.0}},
                                                                     {{0.0, 0.25}, {1.0, 0.75}}}) {
        EXPECT_LT(imbalance_of_tension_along(mesh, from, to, 6), rounding) << to.transpose();
    }
}

/// A crossing beside a node is moved onto it: the crack is not straight there.
bool passes_a_node(const Mesh& mesh, const Vec2& from, const Vec2& to) {
    return std::ranges::any_of(cracked(mesh, {from, to}).pieces, [](const CrackPiece& piece) {
        const auto at_node = [](double place) { return place >= 0.0 && place == std::floor(place); };
        return at_node(piece.entry) || at_node(piece.exit);
    });
}

// Quadrilaterals of Gmsh, and triangles among them that have been split.
TEST(PatchTest, OnMeshesOfGmsh) {
    for (const char* file : {"sent-quads.msh", "sent-mixed.msh"}) {
        const Mesh mesh = coarse::read_mesh_file(mesh_data(file));
        int straight = 0;
        for (int k = 0; k < 10; ++k) {
            const Vec2 tip(25.0 + 10.0 * std::sin(5.0 * k), 50.0 + 20.0 * std::cos(9.0 * k));
            const Vec2 along(std::cos(0.7 * k), std::sin(0.7 * k)), mouth = tip - 200.0 * along;
            const Vec2 other_mouth = tip + 200.0 * along;
            if (passes_a_node(mesh, mouth, other_mouth)) continue;
            EXPECT_LT(imbalance_of_tension_along(mesh, mouth, tip, k % 2 == 0 ? 6 : 1), rounding) << k;
            EXPECT_LT(imbalance_of_tension_along(mesh, mouth, other_mouth, 6), rounding) << k;
            ++straight;
        }
        EXPECT_GE(straight, 5) << file;
    }
}

class PatchWithTip : public ::testing::TestWithParam<int> {};

TEST_P(PatchWithTip, AnywhereInTheBody) {
    for (int k = 0; k < 40; ++k) {
        const Mesh mesh = k % 2 == 0 ? square_mesh(6) : distorted(square_mesh(6), 0.02);
        const Vec2 tip(0.5 + 0.2 * std::sin(5.0 * k), 0.5 + 0.2 * std::cos(9.0 * k));
        const Vec2 along(std::cos(0.7 * k), std::sin(0.7 * k));
        EXPECT_LT(imbalance_of_tension_along(mesh, tip - 2.0 * along, tip, GetParam(), k % 3 == 0 ? 0.25 : 0.5),
                  rounding)
            << k;
    }
}

TEST_P(PatchWithTip, OnEdgesAndNodes) {
    const Mesh mesh = square_mesh(8);
    for (const auto& [from, to] : std::vector<std::pair<Vec2, Vec2>>{{{0.0, 0.5}, {0.5, 0.5}},
                                                                     {{0.0, 0.5}, {0.55, 0.5}},
                                                                     {{0.0, 0.45}, {0.5, 0.45}},
                                                                     {{0.0, 0.0}, {0.5, 0.5}},
                                                                     {{0.0, 0.0}, {0.55, 0.55}},
                                                                     {{0.25, 0.25}, {0.75, 0.75}}}) {
        EXPECT_LT(imbalance_of_tension_along(mesh, from, to, GetParam()), rounding) << to.transpose();
    }
}

INSTANTIATE_TEST_SUITE_P(TipFunctions, PatchWithTip, ::testing::Values(0, 1, 6));

/// Both halves' linear displacement fields; nodes are interpolated on their own side, jumps carry the difference.
struct Halves {
    Eigen::Matrix2d plus, minus;
    Vec2 shift_plus, shift_minus;

    [[nodiscard]] Eigen::VectorXd on(const EnrichedMesh& mesh, const Vec2& from, const Vec2& to) const {
        return by(mesh, [&](int n) {
            return heaviside_side(mesh, n) != 0.0 ? heaviside_side(mesh, n)
                                                  : cross(Vec2(to - from), Vec2(mesh.nodes[at(n)] - from));
        });
    }

    [[nodiscard]] Eigen::VectorXd by(const EnrichedMesh& mesh, const std::function<double(int)>& side) const {
        Eigen::VectorXd u(mesh.unknowns);
        for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) {
            const Vec2 &x = mesh.nodes[at(n)], up = plus * x + shift_plus, down = minus * x + shift_minus;
            u.segment<2>(mesh.unknown(n, 0, 0)) = side(n) > 0.0 ? up : down;
            if (heaviside_side(mesh, n) != 0.0) u.segment<2>(mesh.unknown(n, 1, 0)) = (up - down) / 2.0;
        }
        return u;
    }
};

const std::vector<std::pair<Vec2, Vec2>> through_cracks{{{0.0, 0.47}, {1.0, 0.52}}, {{0.3, 0.0}, {0.8, 1.0}},
                                                        {{0.0, 0.0}, {1.0, 1.0}},   {{0.0, 0.5}, {1.0, 0.5}},
                                                        {{0.0, 0.3}, {0.6, 1.0}},   {{1.0, 0.2}, {0.0, 0.2001}}};

TEST(PatchTest, ABodyCutInTwoMovesApartWithoutForce) {
    const Eigen::Matrix2d turn{{0.0, -1e-3}, {1e-3, 0.0}};
    for (const auto& [from, to] : through_cracks) {
        const Mesh mesh = square_mesh(4);
        coarse::Scene scene = make_scene(mesh, cracked(mesh, {from, to}), steel);
        const Eigen::VectorXd u = Halves{turn, -2.0 * turn, {0.01, 0.02}, {-0.03, 0.0}}.on(scene.enriched, from, to);
        EXPECT_LT(imbalance(scene, u), rounding) << to.transpose();
    }
}

TEST(PatchTest, EachHalfHoldsItsOwnStrain) {
    const Eigen::Matrix2d plus{{1e-3, 4e-4}, {-2e-4, 3e-3}}, minus{{-2e-3, 1e-4}, {5e-4, 1e-3}};
    for (const auto& [from, to] : through_cracks) {
        const Mesh mesh = square_mesh(4);
        coarse::Scene scene = make_scene(mesh, cracked(mesh, {from, to}), steel);
        const Eigen::VectorXd u = Halves{plus, minus, {0.01, 0.02}, {-0.03, 0.0}}.on(scene.enriched, from, to);
        hold_boundary(scene, u);
        const coarse::Structure structure(scene);
        structure.elements().for_each([&](const auto& op) {
            const auto local = gather(u, op.unknowns);
            for (std::size_t q = 0; q < op.points.size(); ++q) {
                const Vec2 d = to - from, r = op.points[q].x - from;
                const Mandel strain = strain_of(cross(d, r) > 0.0 ? plus : minus);
                EXPECT_LT((op.strain(local, q) - strain).norm(), rounding);
            }
        });
    }
}

// It runs along y = 0.5 and turns within the edge from x = 0.25 to 0.5, up or down, or comes in there and runs along.
TEST(PatchTest, ABodyCutAlongPartOfAnEdgeMovesApartWithoutForce) {
    const Eigen::Matrix2d turn{{0.0, -1e-3}, {1e-3, 0.0}};
    for (const std::vector<Vec2>& points : {std::vector<Vec2>{{0.0, 0.5}, {0.4, 0.5}, {1.0, 0.8}},
                                            {{0.0, 0.5}, {0.4, 0.5}, {1.0, 0.1}},
                                            {{0.0, 0.5}, {0.4, 0.5}, {0.4, 1.0}},
                                            {{0.0, 0.8}, {0.4, 0.5}, {1.0, 0.5}}}) {
        for (const bool backwards : {false, true}) {
            std::vector<Vec2> crack = points;
            if (backwards) std::ranges::reverse(crack);
            const Mesh mesh = square_mesh(4);
            coarse::Scene scene = make_scene(mesh, cracked(mesh, crack), steel);
            const bool convex = cross(crack[1] - crack[0], crack[2] - crack[1]) > 0.0;
            const auto side = [&](int n) {
                if (const double known = heaviside_side(scene.enriched, n); known != 0.0) return known;
                const Vec2& x = mesh.nodes[at(n)];
                const bool first = cross(crack[1] - crack[0], x - crack[1]) > 0.0,
                           second = cross(crack[2] - crack[1], x - crack[1]) > 0.0;
                return (convex ? first && second : first || second) ? 1.0 : -1.0;
            };
            const Halves halves{turn, -2.0 * turn, {0.01, 0.02}, {-0.03, 0.0}};
            const Eigen::VectorXd u = halves.by(scene.enriched, side);
            EXPECT_LT(imbalance(scene, u), rounding) << crack[2].transpose() << (backwards ? " backwards" : "");
        }
    }
}

// Every element's bulk is integrated by exactly one side.
TEST(PatchTest, AreasOfStructureAndZoneAddUp) {
    std::mt19937 random(1);
    const Mesh mesh = distorted(square_mesh(8), 0.02);
    coarse::Scene scene = make_scene(mesh, cracked(mesh, {{0.0, 0.46}, {0.33, 0.48}, {0.61, 0.55}}), steel);
    hold_boundary(scene, Eigen::VectorXd::Zero(scene.enriched.unknowns));
    for (int trial = 0; trial < 5; ++trial) {
        ElementSet in_zone(mesh.elements.size());
        for (int e = 0; e < in_zone.size(); ++e)
            if (random() % 2 == 1) in_zone.insert(e);
        double area = 0.0;
        const coarse::Structure structure(scene, in_zone);
        structure.elements().for_each([&](const auto& op) { area += op.area; });
        const EnrichedMesh patch = extract(scene.enriched, in_zone.members());
        for (int e = 0; e < static_cast<int>(patch.elements.size()); ++e)
            area += make_operator(patch, e, piece_in(patch, e), {.subcells = 3}).area;
        EXPECT_NEAR(area, 1.0, 1e-13);
    }
}

}  // namespace
}  // namespace stria::test
