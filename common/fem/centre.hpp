// The centre of a quadrilateral, the mean of its corners, and its size: the same whichever corner it begins with, and
// for its mirror image.
#pragma once

#include <algorithm>
#include <array>
#include <numbers>

#include "common/geometry/vec2.hpp"
#include "common/index.hpp"

namespace stria {

/// Of four corners, mm.
inline Vec2 centre(const std::array<Vec2, 4>& corners) {
    return (corners[0] + corners[1] + corners[2] + corners[3]) / 4.0;
}

/// The longer of the two diagonals, mm.
inline double diagonal(const std::array<Vec2, 4>& corners) {
    return std::max((corners[2] - corners[0]).norm(), (corners[3] - corners[1]).norm());
}

/// Of an element of a mesh, which has `nodes` and `elements`, mm.
template <class AnyMesh> std::array<Vec2, 4> corners_of_element(const AnyMesh& mesh, int element) {
    const std::array<int, 4>& n = mesh.elements[at(element)];
    return {mesh.nodes[at(n[0])], mesh.nodes[at(n[1])], mesh.nodes[at(n[2])], mesh.nodes[at(n[3])]};
}
template <class AnyMesh> Vec2 centre(const AnyMesh& mesh, int element) {
    return centre(corners_of_element(mesh, element));
}
template <class AnyMesh> double diagonal(const AnyMesh& mesh, int element) {
    return diagonal(corners_of_element(mesh, element));
}

/// Edge of a square with that diagonal, mm: what "an element" is long where sizes are told in elements.
template <class AnyMesh> double edge_of_square(const AnyMesh& mesh, int element) {
    return diagonal(mesh, element) / std::numbers::sqrt2;
}

}  // namespace stria
