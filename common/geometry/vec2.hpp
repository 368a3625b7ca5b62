// Places and directions in the plane.
#pragma once

#include <Eigen/Core>

namespace stria {

using Vec2 = Eigen::Vector2d;  // x, y

/// The area of the parallelogram that two vectors span: positive where b lies to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace stria
