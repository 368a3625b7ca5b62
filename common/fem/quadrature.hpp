// Quadrature rules on the line, the square and the triangle, the last also with a vertex where r^(-1/2) is singular.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "common/geometry/vec2.hpp"

namespace stria {

constexpr int max_gauss_points = 32;

struct LinePoint {
    double xi;
    double weight;  // they add up to 2
};

struct SquarePoint {
    Vec2 xi;
    double weight;  // they add up to 4
};

struct TrianglePoint {
    Eigen::Vector3d barycentric;
    double weight;  // they add up to 1: times the triangle's area
};

/// A point where it lies in the body, with its share of the area.
struct PlacedPoint {
    Vec2 x;         // mm
    double weight;  // mm^2
};

/// Gauss-Legendre rule of n points on [-1, 1], 1 <= n <= 32: exact to degree 2 n - 1.
std::span<const LinePoint> gauss_line(int n);

/// n x n points on the square [-1, 1]^2, first coordinate fastest.
std::span<const SquarePoint> gauss_square(int n);

/// Three inner points, exact to degree 2.
std::span<const TrianglePoint> triangle_degree_2();

/// Seven points, exact to degree 5 (Radon).
std::span<const TrianglePoint> triangle_degree_5();

/// Signed area: positive when a, b, c turn counter-clockwise.
double triangle_area(const Vec2& a, const Vec2& b, const Vec2& c);

/// Likewise of a simple polygon.
double polygon_area(std::span<const Vec2> polygon);

/// Points of a triangle (physical, weights with the area) from a rule in barycentric form.
std::vector<PlacedPoint> placed_on_triangle(std::span<const TrianglePoint> rule, const std::array<Vec2, 3>& triangle);

/// Collapsed (Duffy) rule of a triangle whose first vertex is singular: with u the distance from the vertex towards the
/// opposite side and u = v^2, every r^(k/2) with k >= -2 becomes a polynomial in v, so both r^(-1/2) r^(-1/2) and
/// smooth integrands converge at Gauss's rate.
std::vector<PlacedPoint> collapsed_rule(const std::array<Vec2, 3>& triangle, int radial, int angular);

}  // namespace stria
