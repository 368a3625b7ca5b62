// Whether the mesh about a tip serves opening loads and the growth between them.
#pragma once

#include <cstddef>
#include <vector>

#include "coarse/advice/mesh_doubt.hpp"
#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// Nothing where faces never touch and no crack grows. Of a tip about which metal flows:
/// - its forward zone spans too few elements. Five are wanted or, straight ahead of a tip that grows, five in plane
///   strain and ten in plane stress. The `fine.refine` that would do is told;
/// - its distance of closure spans fewer than 1.2 elements;
/// - its distance of closure, which nobody has given, is that of a K which has fallen since;
/// - it grows by its closure in plane strain;
/// - it grows by its opening loads in plane stress, on elements that serve these, and its life may be 3 % too long;
/// - it grows by two elements along it or more at a time, or by one and a part;
/// - it grows in plane stress by more than a tenth of its zone at a time, and beyond the distance of closure.
///
/// Of a tip about which nothing flows: it grows between faces that may touch, and leaves functions behind.
///
/// `K_I`, MPa sqrt(mm): of the cycles that opening loads are asked of (common_K_behind_turns). `distance`, mm: of
/// closure. `missing`: how often the element at the tip ought to have been split and is not (levels_missing).
[[nodiscard]] std::vector<MeshDoubt> doubts_of_openings(const Scene& scene, std::size_t tip, double K_I,
                                                        double distance, int missing);

}  // namespace stria::coarse
