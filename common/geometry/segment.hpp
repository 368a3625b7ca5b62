// Distances of straight segments, and lengths of several.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "common/geometry/vec2.hpp"

namespace stria {

/// Distance from a point to the segment from a to b, which may be one point.
inline double distance_to_segment(const Vec2& x, const Vec2& a, const Vec2& b) {
    const double squared_length = (b - a).squaredNorm();
    const double t = squared_length > 0.0 ? std::clamp((x - a).dot(b - a) / squared_length, 0.0, 1.0) : 0.0;
    return (x - a - t * (b - a)).norm();
}

/// Of a polyline.
inline double length_of(const std::vector<Vec2>& points) {
    double length = 0.0;
    for (std::size_t k = 1; k < points.size(); ++k) length += (points[k] - points[k - 1]).norm();
    return length;
}

}  // namespace stria
