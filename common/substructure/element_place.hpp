// Elements as points: how they are put into an order along an axis, the same on every machine.
#pragma once

#include <span>

#include "common/geometry/vec2.hpp"

namespace stria {

struct ElementPlace {
    Vec2 centre;  // mm
    int element;
};

/// By one coordinate; ties are broken by the other one and by the number.
struct BeforeAlong {
    int axis;
    bool operator()(const ElementPlace& a, const ElementPlace& b) const {
        if (a.centre[axis] != b.centre[axis]) return a.centre[axis] < b.centre[axis];
        if (a.centre[1 - axis] != b.centre[1 - axis]) return a.centre[1 - axis] < b.centre[1 - axis];
        return a.element < b.element;
    }
};

/// Of one place at least.
inline int longer_direction(std::span<const ElementPlace> places) {
    Eigen::Array2d low = places.front().centre, high = low;
    for (const ElementPlace& place : places) {
        low = low.min(place.centre.array());
        high = high.max(place.centre.array());
    }
    return high.y() - low.y() > high.x() - low.x() ? 1 : 0;
}

}  // namespace stria
