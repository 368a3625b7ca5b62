// A crack tip and the frame that it carries.
#pragma once

#include "common/geometry/vec2.hpp"

namespace stria {

/// Crack tip with its frame: theta = 0 ahead of the tip. `upper` = +1 where theta > 0 is the crack's plus side, else
/// -1. Without tip functions the faces end on an element edge near the tip.
struct Tip {
    int crack;
    Vec2 position;
    Vec2 direction;  // unit, out of the crack
    double s;        // arc length at which the faces end
    int upper;
    double beyond = 0.0;  // arc length from there out to the tip; negative where they end ahead of it
    int material = 0;     // of the element that holds it (materials.hpp)

    /// Where the faces end, on the straight line through the tip.
    [[nodiscard]] Vec2 end_of_faces() const { return position - beyond * direction; }
};

/// Whether a tip has stayed where it was. Its direction is that from a point behind it, which a finer mesh may hold
/// elsewhere: beside another node, by a thousandth of an element (snap_fraction).
inline bool same_place(const Tip& a, const Tip& b) {
    constexpr double turn = 1e-2;
    return a.crack == b.crack && a.upper == b.upper && a.position == b.position &&
           (a.direction - b.direction).norm() < turn;
}

}  // namespace stria
