// Eq. (1) on single elements: partition of unity, shift, gradients, and continuity from element to element.
#include "common/enrichment/element_basis.hpp"

#include <gtest/gtest.h>

#include <map>

#include "common/fem/shape_q4.hpp"
#include "common/geometry/clipping.hpp"
#include "tests/support/cracked_mesh.hpp"

namespace stria::test {
namespace {

/// Cut, tip, touching and blending elements: straight, kinked beside the tip, through nodes and along edges.
std::vector<EnrichedMesh> meshes() {
    std::vector<EnrichedMesh> result;
    const Mesh mesh = distorted(square_mesh(7), 0.02), regular = square_mesh(8);
    result.push_back(cracked(mesh, {{0.0, 0.47}, {0.62, 0.52}}));
    result.push_back(cracked(mesh, {{0.13, 0.2}, {0.31, 0.33}, {0.52, 0.41}, {0.88, 0.79}}, 6, 0.25));
    result.push_back(cracked(regular, {{0.0, 0.0}, {0.5625, 0.5625}}));
    result.push_back(cracked(regular, {{0.0, 0.5}, {0.6, 0.5}}));
    result.push_back(cracked(regular, {{0.0, 0.5}, {0.5, 0.5}}));
    result.push_back(cracked(regular, {{0.0, 0.45}, {0.5, 0.45}}));
    result.push_back(cracked(regular, {{0.0, 0.39}, {0.52, 0.39}, {0.57, 0.48}}));    // a kink inside the tip's element
    result.push_back(cracked(regular, {{0.0, 0.39}, {0.49, 0.39}, {0.52, 0.48}}));    // and in the one before
    result.push_back(cracked(regular, {{0.0, 0.25}, {0.375, 0.25}, {0.53, 0.405}}));  // at a node
    result.push_back(cracked(regular, {{0.0, 0.37505}, {0.3754, 0.3751}}));           // just beyond a snapped node
    const Mesh many = distorted(square_mesh(20), 0.005);
    for (const auto& crack : std::vector<std::vector<Vec2>>{{{0.0, 0.47}, {0.52, 0.52}},  // cut
                                                            {{0.0, 0.5}, {0.5, 0.5}},     // along edges
                                                            {{0.0, 0.37}, {0.47, 0.38}, {0.53, 0.43}}}) {  // kinked
        for (const Mesh& background : {many, square_mesh(20)})
            result.push_back(cracked(background, crack, {4, 0.5, coarse::TipSupport::Gathered, {}}));
    }
    // The line behind the tip leaves the crack within the disk, and passes through elements off the crack.
    const std::vector<double> lines{0.0, 1.45, 2.6, 3.45, 4.0, 4.55, 5.4, 6.55, 8.0};
    result.push_back(cracked(coarse::grid_mesh(lines, lines),
                             {{0.0, 4.798}, {2.22, 4.834}, {2.5277, 5.0319}, {2.6, 5.4}, {2.6345, 5.4257}},
                             {4, 0.5, coarse::TipSupport::Gathered, {}}));
    return result;
}

int side_at(const EnrichedMesh& mesh, int element, const Vec2& x) {
    const CrackPiece* piece = piece_in(mesh, element);
    if (piece == nullptr) return 0;
    return side_of_polygon(cut_element(corners_of_element(mesh, element), *piece).left, x) >= 0 ? 1 : -1;
}

BasisValues values_at(const ElementBasis& basis, const Vec2& x, int side) {
    BasisValues values;
    basis.evaluate(map_to_parent(basis.corners(), x), x, side, values);
    return values;
}

template <class Visit> void for_each_element(Visit visit) {
    for (const EnrichedMesh& mesh : meshes()) {
        for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
            visit(mesh, e, ElementBasis(mesh, e, piece_in(mesh, e) != nullptr));
        }
    }
}

const std::vector<Vec2> parents{{-0.93, -0.81}, {0.11, 0.07}, {0.87, -0.35}, {-0.41, 0.77}, {0.66, 0.94}};

TEST(ElementBasis, StandardFunctionsArePartitionOfUnity) {
    for_each_element([](const EnrichedMesh&, int, const ElementBasis& basis) {
        BasisValues values;
        basis.evaluate(parents[1], map_to_physical(basis.corners(), parents[1]), 1, values);
        double sum = 0.0;
        for (int f = 0, previous = -1; f < basis.functions(); ++f) {  // a corner's standard function comes first
            const Eigen::Vector4d shapes = shape_values(parents[1]);
            const bool standard = previous < 3 && std::abs(values.value[f] - shapes[previous + 1]) < 1e-15;
            if (standard) sum += values.value[f], ++previous;
        }
        EXPECT_NEAR(sum, 1.0, 1e-15);
    });
}

TEST(ElementBasis, EnrichedFunctionsVanishAtTheNodes) {
    for_each_element([](const EnrichedMesh& mesh, int e, const ElementBasis& basis) {
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const int node = mesh.elements[at(e)][corner];
            const Vec2& x = mesh.nodes[at(node)];
            const bool on_faces = std::ranges::any_of(mesh.pieces, [&](const CrackPiece& piece) {
                return std::ranges::find(piece.points, x) != piece.points.end();
            });
            const bool from_below = on_faces && (mesh.element_side[at(e)] < 0 || side_at(mesh, e, x) == 0);
            if (from_below) continue;  // a node on the crack counts as plus: from minus its functions show the jump
            const BasisValues values = values_at(basis, x, side_at(mesh, e, x));
            for (int f = 0; f < basis.functions(); ++f) {
                const bool own = basis.unknowns()[at(2 * f)] == mesh.unknown(node, 0, 0);
                EXPECT_NEAR(values.value[f], own ? 1.0 : 0.0, 1e-13);  // the rounding of the inverse map
            }
        }
    });
}

TEST(ElementBasis, GradientsMatchDifferences) {
    for_each_element([](const EnrichedMesh& mesh, int e, const ElementBasis& basis) {
        constexpr double step = 1e-6;
        if (!basis.enriched()) return;
        for (const Vec2& xi : parents) {
            const Vec2 x = map_to_physical(basis.corners(), xi);
            const int side = side_at(mesh, e, x);
            const bool near_tip =
                std::ranges::any_of(mesh.tips, [&](const Tip& t) { return (x - t.position).norm() < 0.01; });
            if (near_tip) continue;
            const BasisValues exact = values_at(basis, x, side);
            for (int axis = 0; axis < 2; ++axis) {
                const Vec2 shift = step * Vec2::Unit(axis);
                const Eigen::VectorXd difference =
                    (values_at(basis, x + shift, side).value - values_at(basis, x - shift, side).value) / (2.0 * step);
                EXPECT_LT((difference - exact.gradient.col(axis)).cwiseAbs().maxCoeff(), 2e-7);
            }
        }
    });
}

/// Values by unknown, seen from inside an element.
std::map<int, double> seen_from(const EnrichedMesh& mesh, int e, const Vec2& x) {
    const ElementBasis basis(mesh, e, piece_in(mesh, e) != nullptr);
    const auto corners = corners_of_element(mesh, e);
    const Vec2 centre = (corners[0] + corners[1] + corners[2] + corners[3]) / 4.0;
    const BasisValues values = values_at(basis, x, side_at(mesh, e, x + 1e-7 * (centre - x)));
    std::map<int, double> result;
    for (int f = 0; f < basis.functions(); ++f) {
        if (std::abs(values.value[f]) > 1e-13) result[basis.unknowns()[at(2 * f)]] = values.value[f];
    }
    return result;
}

TEST(ElementBasis, NothingTearsOffTheCrack) {
    int number = 0;
    for (const EnrichedMesh& mesh : meshes()) {
        ++number;
        std::map<std::pair<int, int>, std::vector<int>> elements_of_edge;
        for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
            const auto& nodes = mesh.elements[at(e)];
            for (std::size_t k = 0; k < 4; ++k)
                elements_of_edge[std::minmax(nodes[k], nodes[(k + 1) % 4])].push_back(e);
        }
        for (const auto& [edge, elements] : elements_of_edge) {
            if (elements.size() < 2) continue;
            for (const double t : {0.013, 0.27, 0.61, 0.987}) {
                const Vec2 x = (1.0 - t) * mesh.nodes[at(edge.first)] + t * mesh.nodes[at(edge.second)];
                const bool on_crack = std::ranges::any_of(mesh.pieces, [&](const CrackPiece& piece) {
                    return piece.neighbour >= 0 && intersect(piece.points[0], piece.points[1], x, x);
                });
                if (on_crack) continue;
                auto difference = seen_from(mesh, elements[0], x);
                for (const auto& [unknown, value] : seen_from(mesh, elements[1], x)) difference[unknown] -= value;
                for (const auto& [unknown, value] : difference) {
                    EXPECT_NEAR(value, 0.0, 1e-12) << "mesh " << number << " at " << x.transpose();
                }
            }
        }
    }
}

}  // namespace
}  // namespace stria::test
