// The strain that goes with an initial stress.
#pragma once

#include "common/material/materials.hpp"

namespace stria {

/// The displacement gradient, without rotation, with which a load would make the initial stress at a place in an
/// element of a material.
inline Eigen::Matrix2d gradient_of_initial_stress(const Materials& materials, const Vec2& x, int material) {
    return in_plane(materials.elastic(material).strain_in_plane(materials.initial_stress().at(x, material)));
}

}  // namespace stria
