// The two sides of cut elements, and the interface elements of Fig. 2.
#include "common/integration/cut_element.hpp"

#include <gtest/gtest.h>

#include "common/geometry/clipping.hpp"
#include "tests/support/cracked_mesh.hpp"

namespace stria::test {
namespace {

/// Straight, kinked, through nodes, with one and two tips.
std::vector<EnrichedMesh> meshes() {
    std::vector<EnrichedMesh> result;
    const Mesh mesh = distorted(square_mesh(5), 0.03), regular = square_mesh(4);
    result.push_back(cracked(mesh, {{0.0, 0.47}, {0.62, 0.52}}));
    result.push_back(cracked(mesh, {{0.13, 0.2}, {0.31, 0.33}, {0.52, 0.41}, {0.88, 0.79}}));
    result.push_back(cracked(regular, {{0.0, 0.0}, {0.65, 0.65}}));
    return result;
}

TEST(CutElement, AreasOfBothSidesAddUp) {
    for (const EnrichedMesh& mesh : meshes()) {
        for (const CrackPiece& piece : mesh.pieces) {
            const auto corners = corners_of_element(mesh, piece.element);
            const CutElement cut = cut_element(corners, piece);
            EXPECT_GT(polygon_area(cut.left), 0.0);
            EXPECT_GT(polygon_area(cut.right), 0.0);
            EXPECT_NEAR(polygon_area(cut.left) + polygon_area(cut.right), polygon_area(corners), 1e-15);
        }
    }
}

TEST(CutElement, PlusIsLeftOfTheCrack) {
    const EnrichedMesh mesh = cracked(square_mesh(4), {{0.0, 0.4}, {0.6, 0.4}});
    const CutElement cut = cut_element(corners_of_element(mesh, 5), *piece_in(mesh, 5));
    EXPECT_EQ(cut.side_of({0.3, 0.45}), 1);
    EXPECT_EQ(cut.side_of({0.3, 0.35}), -1);
}

TEST(CutElement, TipGoesStraightOn) {
    const EnrichedMesh mesh = cracked(square_mesh(4), {{0.0, 0.4}, {0.6, 0.4}});
    const CutElement cut = cut_element(corners_of_element(mesh, 6), *piece_in(mesh, 6));
    ASSERT_EQ(cut.tips.size(), 1U);
    ASSERT_EQ(cut.continuation.size(), 1U);
    EXPECT_EQ(cut.continuation[0].first, Vec2(0.6, 0.4));
    EXPECT_LT((cut.continuation[0].second - Vec2(0.75, 0.4)).norm(), 1e-15);
}

TEST(InterfaceElements, AddUpToTheCrack) {
    for (const EnrichedMesh& mesh : meshes()) {
        for (const int subcells : {1, 2, 3, 5}) {
            double length = 0.0;
            for (const CrackPiece& piece : mesh.pieces) {
                const InterfacePoints ends =
                    interface_elements(corners_of_element(mesh, piece.element), piece, subcells);
                for (std::size_t k = 1; k < ends.points.size(); ++k) {
                    length += (ends.points[k] - ends.points[k - 1]).norm();
                    EXPECT_NEAR((ends.points[k] - ends.points[k - 1]).norm(), ends.s[k] - ends.s[k - 1], 1e-14);
                }
            }
            EXPECT_NEAR(length, mesh.tips.back().s, 1e-13);
        }
    }
}

TEST(InterfaceElements, EachLiesInOneSubQuadrangle) {
    for (const EnrichedMesh& mesh : meshes()) {
        for (const CrackPiece& piece : mesh.pieces) {
            const auto corners = corners_of_element(mesh, piece.element);
            const int s = 4;
            const InterfacePoints ends = interface_elements(corners, piece, s);
            for (std::size_t k = 1; k < ends.points.size(); ++k) {
                int holders = 0;
                for (int cell = 0; cell < s * s; ++cell) {
                    const int i = cell % s, j = cell / s;
                    const std::array<Vec2, 4> quad{grid_corner(corners, s, i, j), grid_corner(corners, s, i + 1, j),
                                                   grid_corner(corners, s, i + 1, j + 1),
                                                   grid_corner(corners, s, i, j + 1)};
                    const auto holds = [&](double t) {
                        return side_of_polygon(quad, (1.0 - t) * ends.points[k - 1] + t * ends.points[k]) >= 0;
                    };
                    holders += holds(1e-6) && holds(0.5) && holds(1.0 - 1e-6) ? 1 : 0;
                }
                EXPECT_GE(holders, 1);
            }
        }
    }
}

}  // namespace
}  // namespace stria::test
