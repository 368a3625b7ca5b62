// Bilinear quadrilateral: partition of unity, gradients, map and inverse map.
#include "common/fem/shape_q4.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "common/fem/mesh.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

const QuadNodes distorted{Vec2{0.2, -0.1}, Vec2{2.0, 0.3}, Vec2{1.7, 1.9}, Vec2{-0.3, 1.1}};
const QuadNodes rectangle{Vec2{3.0, 5.0}, Vec2{7.0, 5.0}, Vec2{7.0, 7.0}, Vec2{3.0, 7.0}};
const std::vector<Vec2> parents{{0.0, 0.0}, {-1.0, -1.0}, {1.0, -0.3}, {0.37, 0.81}, {-0.9, 0.55}, {1.0, 1.0}};

TEST(ShapeQ4, SumsToOneAndReproducesLinearFields) {
    for (const Vec2& xi : parents) {
        const ShapeQ4 shape = shape_q4(distorted, xi);
        EXPECT_NEAR(shape.value.sum(), 1.0, 1e-15);
        Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
        for (int node = 0; node < 4; ++node) {
            gradient += distorted[at(node)] * shape.gradient.row(node);
        }
        EXPECT_LT((gradient - Eigen::Matrix2d::Identity()).norm(), 1e-14);
    }
}

TEST(ShapeQ4, IsOneAtItsNodeAndZeroAtTheOthers) {
    const std::array<Vec2, 4> corners{Vec2(-1.0, -1.0), Vec2(1.0, -1.0), Vec2(1.0, 1.0), Vec2(-1.0, 1.0)};
    for (int node = 0; node < 4; ++node) EXPECT_EQ(shape_values(corners[at(node)]), Eigen::Vector4d::Unit(node));
}

TEST(ShapeQ4, GradientsMatchDifferences) {
    constexpr double step = 1e-6;
    for (const Vec2& xi : parents) {
        const ShapeQ4 shape = shape_q4(distorted, xi);
        const Vec2 x = map_to_physical(distorted, xi);
        for (int axis = 0; axis < 2; ++axis) {
            const Vec2 shift = step * Vec2::Unit(axis);
            const Eigen::Vector4d difference = (shape_values(map_to_parent(distorted, x + shift)) -
                                                shape_values(map_to_parent(distorted, x - shift))) /
                                               (2.0 * step);
            EXPECT_LT((difference - shape.gradient.col(axis)).norm(), 1e-8);
        }
    }
}

TEST(ShapeQ4, JacobianOfRectangleIsAreaRatio) { EXPECT_DOUBLE_EQ(shape_q4(rectangle, {0.3, -0.7}).jacobian, 2.0); }

TEST(ShapeQ4, InverseMapReturns) {
    for (const Vec2& xi : parents) {
        EXPECT_LT((map_to_parent(distorted, map_to_physical(distorted, xi)) - xi).norm(), 1e-13);
        EXPECT_LT((map_to_parent(rectangle, map_to_physical(rectangle, xi)) - xi).norm(), 4e-15);
    }
    EXPECT_EQ(map_to_parent(rectangle, {4.0, 6.5}), Vec2(-0.5, 0.5));
    EXPECT_EQ(map_to_parent(rectangle, {9.0, 6.0}), Vec2(2.0, 0.0));  // outside is fine where the map is affine
}

TEST(Mesh, KnowsTheElementsAroundEachNode) {
    Mesh mesh;
    mesh.nodes.resize(8);
    mesh.elements = {{0, 1, 4, 3}, {1, 2, 5, 4}};
    mesh.hanging = {{7, {1, 2}, 1}};
    const IndexLists around = elements_around_nodes(mesh);
    const auto are = [&](std::size_t node, const std::vector<int>& elements) {
        return std::ranges::equal(around[node], elements);
    };
    EXPECT_TRUE(are(0, {0}));
    EXPECT_TRUE(are(4, {0, 1}));
    EXPECT_TRUE(are(6, {}));
    EXPECT_TRUE(are(7, {1}));
}

}  // namespace
}  // namespace stria
