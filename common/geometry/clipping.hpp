// Exact predicates and intersections (CGAL hidden here; nothing else in the project sees it).
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "common/geometry/vec2.hpp"

namespace stria {

/// Sign of the area of triangle abc: +1 where c lies left of a -> b, -1 right, 0 exactly on the line.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// Intersection of segments ab and cd: nothing, one point (first == second), or the two ends of an overlap. Whether
/// there is one is decided exactly; the points are rounded, and within the boxes of both.
std::optional<std::pair<Vec2, Vec2>> intersect(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// +1 strictly inside a simple polygon, 0 on its boundary, -1 outside. Exact.
int side_of_polygon(std::span<const Vec2> polygon, const Vec2& point);

/// Triangulates a convex polygon so that no triangle crosses any of the given segments (constrained Delaunay; segments
/// lie inside the polygon and may end there). Triangles are counter-clockwise.
std::vector<std::array<Vec2, 3>> triangulate(std::span<const Vec2> polygon,
                                             std::span<const std::pair<Vec2, Vec2>> segments);

}  // namespace stria
