// A plate of elements of 1 mm, an edge crack whose faces may touch, and metal that flows.
#pragma once

#include "tests/support/specimens.hpp"

namespace stria::test {

inline Case plate_that_flows() {
    Case input = specimen("plate", 20.0, {{0.0, 10.3}, {8.3, 10.3}});
    input.mesh.width = 20.0;
    input.mesh.size = 1.0;
    input.material.yield_stress = 300.0;
    input.cracks[0].contact = ContactSection{};
    return input;
}

}  // namespace stria::test
