// A round hole in a structured mesh: its nodes are those of a square whose node lines are moved onto the circle.
#pragma once

#include <array>

#include "common/geometry/vec2.hpp"

namespace stria::coarse {

/// A hole of a given radius, and the distance from its middle up to which nodes are moved to make it, mm.
struct PinHole {
    Vec2 middle;
    double radius, reach;

    /// Half the edge of the square that becomes the hole: as large as the hole, so that about as much is moved outwards
    /// as inwards.
    [[nodiscard]] double half_edge() const;
    /// Along one axis the node lines that the square needs: at its ends, and between them so that the circle is never
    /// coarser than a polygon of 24 equal edges, however large the elements.
    [[nodiscard]] std::array<double, 7> lines(int axis) const;
    [[nodiscard]] bool square_holds(const Vec2& x) const;
    /// Where a node outside of the square goes: on its ray from the middle, by less the farther it is away.
    [[nodiscard]] Vec2 moved(const Vec2& x) const;
};

}  // namespace stria::coarse
