// Rectangles as structured meshes from two graded axes.
#pragma once

#include <span>

#include "coarse/specimen/specimen.hpp"

namespace stria::coarse {

/// Structured mesh of two axes with the boundaries "bottom", "right", "top" and "left", each in the direction of its
/// axis.
Mesh grid_mesh(std::span<const double> xs, std::span<const double> ys);

/// A body meshed as the section's size and gradings ask, with the `lines` that lie in it. Throws CaseError naming the
/// key whose value is not allowed.
Mesh structured_mesh(const MeshSection& section, const Body& body, const MeshLines& lines = {});

/// [0, width] x [0, height].
Body rectangle(const MeshSection& section);
Mesh rectangle_mesh(const MeshSection& section, const MeshLines& lines = {});

}  // namespace stria::coarse
