// Ways along which a crack grows straight on, and what it has cut already stays the same to the bit.
#pragma once

#include <cmath>

#include "common/geometry/vec2.hpp"

namespace stria {

/// Along a way, its larger component 1. Ends that a crack reaches along one line lie beside it by rounding, each by
/// another: the smaller component is put onto a grid, which is a thousand times as wide once the way is some
/// millimetres long. So it is the same for all of them.
inline Vec2 rounded_direction(const Vec2& way) {
    constexpr double grid = 0x1p-40;
    const Eigen::Index larger = std::abs(way.y()) > std::abs(way.x()) ? 1 : 0;
    Vec2 direction = way / way[larger];
    direction[1 - larger] = grid * std::round(direction[1 - larger] / grid);
    return direction;
}

/// `end`, mm, put onto the rounded direction from the point before it: by at most 1e-12 of the way, across it.
inline Vec2 on_rounded_way(const Vec2& before, Vec2 end) {
    const Vec2 way = end - before, direction = rounded_direction(way);
    const Eigen::Index smaller = std::abs(way.y()) > std::abs(way.x()) ? 0 : 1;
    end[smaller] = before[smaller] + way[1 - smaller] * direction[smaller];
    return end;
}

}  // namespace stria
