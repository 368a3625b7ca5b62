// Rectangles [0, width] x [0, height] as structured meshes from two graded axes.
#pragma once

#include <span>

#include "common/fem/mesh.hpp"
#include "common/io/case.hpp"

namespace stria::coarse {

/// Structured mesh of two axes with the boundaries "bottom", "right", "top" and "left", each in the direction of its
/// axis.
Mesh grid_mesh(std::span<const double> xs, std::span<const double> ys);

/// Rectangle graded as the section asks. Throws CaseError naming the key whose value is not allowed.
Mesh rectangle_mesh(const MeshSection& section);

}  // namespace stria::coarse
