// What a tree of fronts is made of: unknowns, elements, and what is kept to the root.
#pragma once

#include <vector>

#include "common/geometry/vec2.hpp"

namespace stria {

struct FrontLayout {
    int unknowns = 0;                                // numbered 0..unknowns-1
    int multipliers = 0;                             // the last so many of them: Lagrange multipliers
    std::vector<std::vector<int>> element_unknowns;  // per element, the order of its matrix
    std::vector<Vec2> centres;                       // per element, mm: what is bisected
    std::vector<Vec2> busy;                          // centres about which elements change all the time, mm
    std::vector<int> boundary;                       // unknowns kept to the root, in this order
    int leaf_elements = 12;
};

}  // namespace stria
