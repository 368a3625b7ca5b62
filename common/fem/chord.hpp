// How long a quadrilateral is in a direction.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "common/fem/centre.hpp"

namespace stria {

/// Of the line through the centre of four convex corners along a unit `direction`, what lies inside, mm.
inline double chord(const std::array<Vec2, 4>& corners, const Vec2& direction) {
    const Vec2 middle = centre(corners), across(-direction.y(), direction.x());
    double from = 0.0, to = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 begins = corners[k] - middle, ends = corners[(k + 1) % 4] - middle;
        const double left = across.dot(begins), right = across.dot(ends);
        if ((left < 0.0) == (right < 0.0)) continue;
        const double where = std::lerp(direction.dot(begins), direction.dot(ends), left / (left - right));
        from = std::min(from, where);
        to = std::max(to, where);
    }
    return to - from;
}

}  // namespace stria
