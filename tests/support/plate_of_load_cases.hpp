// A cracked plate that is pulled, moved and pressed, by loads with factors of their own.
#pragma once

#include "tests/support/load_cases.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::test {

/// [load] pulls at its top and moves its bottom; "moved" moves that, too, and "pressed" presses its right side.
inline Case plate_of_load_cases(double size, bool plastic, bool contact) {
    Case input = pulled_plate(size, plastic, contact);
    input.boundaries[1].traction.reset();
    input.boundaries[1].displacement = {0.0, -2e-4};
    input.load_cases = {lagging_load("moved", 1.0), dead_load("pressed", 1.0)};
    BoundarySection moved = held("bottom"), pressed = pulled_in_case("pressed", "right", {0.1, 0.0});
    moved.displacement[1] = 3e-4;
    moved.load_case = "moved";
    pressed.pressure = 0.5;
    input.boundaries.insert(input.boundaries.end(), {moved, pressed});
    return input;
}

}  // namespace stria::test
