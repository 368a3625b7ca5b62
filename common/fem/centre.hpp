// The centre of a quadrilateral: the mean of its corners.
#pragma once

#include <array>

#include "common/geometry/vec2.hpp"
#include "common/index.hpp"

namespace stria {

/// Of four corners, mm.
inline Vec2 centre(const std::array<Vec2, 4>& corners) {
    return (corners[0] + corners[1] + corners[2] + corners[3]) / 4.0;
}

/// Of an element of a mesh, which has `nodes` and `elements`, mm.
template <class AnyMesh> Vec2 centre(const AnyMesh& mesh, int element) {
    const std::array<int, 4>& n = mesh.elements[at(element)];
    return (mesh.nodes[at(n[0])] + mesh.nodes[at(n[1])] + mesh.nodes[at(n[2])] + mesh.nodes[at(n[3])]) / 4.0;
}

}  // namespace stria
