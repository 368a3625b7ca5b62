// A square plate with an edge crack, pulled at its ends: for tests of what is chosen about a tip.
#pragma once

#include "common/case/case.hpp"

namespace stria::test {

/// 20 mm wide, the crack 7.3 mm long, at 10.4 mm of its height.
inline Case pulled_plate(double size, bool plastic, bool contact) {
    Case input;
    input.mesh = {.specimen = "plate", .width = 20.0, .height = 20.0, .size = size, .grading = {}};
    input.material.young = 200e3;
    input.material.poisson = 0.3;
    if (plastic) input.material.yield_stress = 300.0;
    input.cracks.resize(1);
    input.cracks[0].points = {{0.0, 10.4}, {7.3, 10.4}};
    if (contact) input.cracks[0].contact = ContactSection{};
    for (const double side : {1.0, -1.0}) {
        BoundarySection pulled;
        pulled.on = side > 0.0 ? "top" : "bottom";
        pulled.traction = Vec2(0.0, side);
        input.boundaries.push_back(pulled);
    }
    return input;
}

}  // namespace stria::test
