// Where the points of a cut element stand.
#include "common/integration/element_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/cracked_mesh.hpp"

namespace stria::test {
namespace {

// Triangles of a rectangle stand on one of its diagonals: a mirror image had points elsewhere.
TEST(ElementPoints, OfACutAlongAnEdgeAreTheirOwnMirrorImage) {
    const EnrichedMesh mesh = cracked(square_mesh(4), {{0.0, 0.42}, {0.6, 0.42}});
    const auto corners = corners_of_element(mesh, 5);
    const CutElement cut = cut_element(corners, *piece_in(mesh, 5));
    const double middle = 0.5 * (corners[0].x() + corners[2].x());
    for (const int subcells : {1, 2}) {
        const std::vector<IntegrationPoint> points = place_points(corners, &cut, {}, false, {.subcells = subcells});
        EXPECT_EQ(points.size(), subcells == 1 ? 8U : 24U) << "cells that are cut have two halves";
        double area = 0.0;
        for (const IntegrationPoint& point : points) {
            area += point.weight;
            const Vec2 mirrored(2.0 * middle - point.x.x(), point.x.y());
            EXPECT_TRUE(std::ranges::any_of(points, [&](const IntegrationPoint& other) {
                return (other.x - mirrored).norm() < 1e-14 && std::abs(other.weight - point.weight) < 1e-16 &&
                       other.side == point.side;
            }));
            EXPECT_EQ(point.side, cut.side_of(point.x));
        }
        EXPECT_NEAR(area, 1.0 / 16.0, 1e-15);
    }
}

}  // namespace
}  // namespace stria::test
