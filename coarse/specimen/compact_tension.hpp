// The compact specimen C(T) of ASTM E647, E399 and E1820, all of it in proportion to its width W.
#pragma once

#include "coarse/specimen/specimen.hpp"

namespace stria::coarse {

/// [-0.25 W, W] x [-0.6 W, 0.6 W]: the origin is on the load line at mid-height.
Body compact_tension(const MeshSection& section);

/// The notch is part of the crack (its `notch` length). The holes of radius 0.125 W at (0, +-0.275 W) are round,
/// whatever the sizes of elements. "pin-top" and "pin-bottom" press on 30 degrees to either side of their outer ends,
/// evenly over the width across the load, and their displacement is the mean of that arc, likewise. Material within 0.2
/// W of a pin's middle never yields.
Mesh compact_tension_mesh(const MeshSection& section, const MeshLines& lines = {});

}  // namespace stria::coarse
