// Bilinear quadrilateral: shape functions, their physical gradients, and the map between parent square and element.
// Parent nodes (-1,-1), (1,-1), (1,1), (-1,1); edge k runs from node k to node (k + 1) % 4.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>

#include "common/error.hpp"
#include "common/geometry/vec2.hpp"
#include "common/index.hpp"

namespace stria {

using QuadNodes = std::array<Vec2, 4>;  // mm, counter-clockwise

struct ShapeQ4 {
    Eigen::Vector4d value;
    Eigen::Matrix<double, 4, 2> gradient;  // dN/dx, 1/mm
    double jacobian;                       // area ratio physical : parent, mm^2
};

inline Eigen::Vector4d shape_values(Vec2 xi) {
    const double left = 0.5 * (1.0 - xi.x()), right = 0.5 * (1.0 + xi.x());
    const double below = 0.5 * (1.0 - xi.y()), above = 0.5 * (1.0 + xi.y());
    return {left * below, right * below, right * above, left * above};
}

/// dN/dxi.
inline Eigen::Matrix<double, 4, 2> parent_gradients(Vec2 xi) {
    const double left = 0.25 * (1.0 - xi.x()), right = 0.25 * (1.0 + xi.x());
    const double below = 0.25 * (1.0 - xi.y()), above = 0.25 * (1.0 + xi.y());
    return Eigen::Matrix<double, 4, 2>{{-below, -left}, {below, -right}, {above, right}, {-above, left}};
}

/// dx/dxi: row i, column j: dx_i/dxi_j.
inline Eigen::Matrix2d jacobian_matrix(const QuadNodes& nodes, const Eigen::Matrix<double, 4, 2>& gradients) {
    Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();
    for (int node = 0; node < 4; ++node) {
        jacobian += nodes[at(node)] * gradients.row(node);
    }
    return jacobian;
}

inline ShapeQ4 shape_q4(const QuadNodes& nodes, Vec2 xi) {
    const Eigen::Matrix<double, 4, 2> gradients = parent_gradients(xi);
    const Eigen::Matrix2d jacobian = jacobian_matrix(nodes, gradients);
    return {shape_values(xi), gradients * jacobian.inverse(), jacobian.determinant()};
}

inline Vec2 map_to_physical(const QuadNodes& nodes, Vec2 xi) {
    const Eigen::Vector4d value = shape_values(xi);
    return value[0] * nodes[0] + value[1] * nodes[1] + value[2] * nodes[2] + value[3] * nodes[3];
}

/// Inverse of map_to_physical by Newton's method from the centre: one step on a parallelogram, where the map is affine.
/// Throws NumericalFailure for points so far outside a distorted element that it has no inverse there.
inline Vec2 map_to_parent(const QuadNodes& nodes, const Vec2& x) {
    constexpr int max_steps = 30;
    constexpr double last_correction = 1e-9;  // convergence is quadratic: the error after it is rounding
    Vec2 xi = Vec2::Zero();
    for (int step = 0; step < max_steps; ++step) {
        const Eigen::Matrix2d jacobian = jacobian_matrix(nodes, parent_gradients(xi));
        const Vec2 correction = jacobian.inverse() * (x - map_to_physical(nodes, xi));
        xi += correction;
        if (correction.cwiseAbs().maxCoeff() <= last_correction * std::max(1.0, xi.cwiseAbs().maxCoeff())) return xi;
    }
    throw NumericalFailure("no parent coordinates: the point is far outside a distorted element");
}

}  // namespace stria
