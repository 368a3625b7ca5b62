#include "common/integration/parts_of_elements.hpp"

#include <gtest/gtest.h>

#include <random>

#include "common/enrichment/element_basis.hpp"
#include "common/fem/shape_q4.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/plates.hpp"
#include "tests/support/refined_squares.hpp"

namespace stria {
namespace {

Vec2 displacement_in(const EnrichedMesh& mesh, int element, const Vec2& x, int side, const Eigen::VectorXd& u) {
    const ElementBasis basis(mesh, element, test::piece_in(mesh, element) != nullptr);
    BasisValues values;
    basis.evaluate(map_to_parent(basis.corners(), x), x, side, values);
    Vec2 sum = Vec2::Zero();
    for (int f = 0; f < basis.functions(); ++f)
        for (int c = 0; c < 2; ++c) sum[c] += values.value[f] * u[basis.unknowns()[at(2 * f + c)]];
    return sum;
}

/// Elements that hold a tip, and those beside them, stay whole.
ElementSet about_tips(const EnrichedMesh& mesh) {
    ElementSet found(mesh.elements.size());
    for (int e = 0; e < found.size(); ++e) {
        const auto corners = corners_of_element(mesh, e);
        const double diagonal = (corners[2] - corners[0]).norm();
        for (const Tip& tip : mesh.tips)
            if (((corners[0] + corners[2]) / 2.0 - tip.position).norm() < 1.6 * diagonal) found.insert(e);
    }
    return found;
}

/// The field of a random displacement before and after elements have been split, at places on either side of cracks.
struct Compared {
    double difference = 0.0;
    int cut_parents = 0, freed = 0;  // nodes that hung
};

Compared compare(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const Vec2 first(0.2 + 0.5 * unit(random), 0.2 + 0.6 * unit(random)), next(0.3 + 0.5 * unit(random), unit(random));
    const Mesh start = test::refined(seed % 2 == 0 ? test::distorted(test::square_mesh(7), 0.02) : test::square_mesh(7),
                                     {{first, first, 0.15, 2, 0.0}})
                           .mesh;
    const double angle = 0.6 * (unit(random) - 0.5);
    const Vec2 along(std::cos(angle), std::sin(angle)), on_crack(0.5, 0.3 + 0.4 * unit(random));
    std::vector<Vec2> points{on_crack - 2.0 * along, on_crack + (seed % 3 == 0 ? 2.0 : 0.2) * along};
    if (seed % 10 == 1) points = {{-1.0, 3.0 / 7.0}, {seed % 3 == 0 ? 2.0 : 0.5, 3.0 / 7.0}};  // along element edges
    const EnrichedMesh before = test::cracked(start, points, 0);
    const coarse::RefinedMesh finer = test::refined(start, {{next, next, 0.2, 3, 0.0}}, about_tips(before));
    const EnrichedMesh now = test::cracked(finer.mesh, points, 0);
    const Eigen::VectorXd u = test::random_vector(before.unknowns, 1.0, seed);
    const Eigen::VectorXd v =
        carry_over(before, u, now, on_parts(before, u, now, finer.part_of, Eigen::VectorXd::Zero(now.unknowns)));
    Compared result;
    for (int e = 0; e < std::ssize(now.elements); ++e) {
        const int whole = finer.part_of[at(e)] >= 0 ? finer.part_of[at(e)] : e;
        const CrackPiece *piece = test::piece_in(before, whole), *part = test::piece_in(now, e);
        if (finer.part_of[at(e)] >= 0 && piece != nullptr) ++result.cut_parents;
        const auto corners = corners_of_element(now, e);
        for (const Vec2& xi : {Vec2(-0.7, 0.3), Vec2(0.4, 0.6), Vec2(0.1, -0.8)}) {
            const Vec2 x = map_to_physical(corners, xi);
            const int side = piece != nullptr ? cut_element(corners_of_element(before, whole), *piece).side_of(x) : 0;
            const int own = part != nullptr ? cut_element(corners, *part).side_of(x) : 0;
            const Vec2 difference = displacement_in(now, e, x, own, v) - displacement_in(before, whole, x, side, u);
            result.difference = std::max(result.difference, difference.norm());
        }
    }
    for (const TiedNode& tied : before.tied) result.freed += now.tie(tied.node) == nullptr ? 1 : 0;
    return result;
}

TEST(PartsOfElements, HaveTheFieldOfTheirWholeOverManyCracks) {
    int cut_parents = 0, freed = 0;
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Compared compared = compare(seed);
        EXPECT_LT(compared.difference, 1e-12) << "seed " << seed;
        cut_parents += compared.cut_parents;
        freed += compared.freed;
    }
    EXPECT_GT(cut_parents, 100);
    EXPECT_GT(freed, 50);
}

}  // namespace
}  // namespace stria
