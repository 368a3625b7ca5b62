// The rings about each tip over which fracture parameters are integrated, chosen from the geometry alone.
#pragma once

#include <vector>

#include "coarse/model/scene.hpp"
#include "common/fracture/ring_weights.hpp"

namespace stria::coarse {

inline constexpr std::size_t most_rings = 5;

/// Outer radius of the largest ring around a tip: within its reach, off forces, and inside the tip's material.
double largest_ring(const Scene& scene, int tip);

/// Concentric rings within the largest one. The first is the thickest: J is taken there. Of the others those are left
/// that are at least two elements thick, which also keeps them two elements off the tip's own.
std::vector<Annulus> rings_about(const Scene& scene, int tip);

}  // namespace stria::coarse
