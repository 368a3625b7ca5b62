// The points of a crack that shape it.
#pragma once

#include <cmath>
#include <vector>

#include "common/geometry/vec2.hpp"

namespace stria {

/// Of a polyline its ends and the points at which it bends. A point on a straight stretch is where its author has put
/// one, and the crack is the same without it. On a mesh it would be one more corner of the parts of a cut element, and
/// so of the triangles in which they are integrated.
inline std::vector<Vec2> ends_and_bends(const std::vector<Vec2>& points) {
    constexpr double rounding = 1e-9;  // rad
    std::vector<Vec2> bends;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (k > 0 && k + 1 < points.size()) {
            const Vec2 before = points[k] - bends.back(), after = points[k + 1] - points[k];
            const double ahead = before.dot(after);  // a crack that turns back is refused, and where is said
            if (ahead > 0.0 && std::abs(cross(before, after)) <= rounding * ahead) continue;
        }
        bends.push_back(points[k]);
    }
    return bends;
}

}  // namespace stria
