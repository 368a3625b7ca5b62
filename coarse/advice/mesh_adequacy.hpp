// Whether the mesh at the tips is fine enough for opening loads and growth: said before a run, not found out after it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// What the mesh is too coarse for, one sentence each.
///
/// Of the body: a region whose outline elements do not follow. Functions that stand at tips whose elements are small
/// enough for none, because other tips have larger ones.
///
/// Of each tip the first that holds: a bend less than two elements behind it; no ring of three elements about it; no
/// ring of four in its own metal, where there are several.
///
/// Of each tip about which metal flows, where its faces may touch or cracks grow:
/// - its forward zone spans too few elements. Five are wanted or, straight ahead of a tip that grows, five in plane
///   strain and ten in plane stress. The `fine.refine` that would do is told;
/// - its distance of closure spans fewer than 1.2 elements;
/// - it grows by two elements along it or more at a time, or by one and a part;
/// - it grows in plane stress by more than a tenth of its zone at a time, and beyond the distance of closure;
/// - it grows by its closure in plane strain.
///
/// Of each tip about which nothing flows: it grows between faces that may touch, and leaves functions behind.
///
/// `K_I`, MPa sqrt(mm): of the cycles that opening loads are asked of (common_K_I). `distance`, mm: of closure
/// (closure_distances). Both hold one number per tip.
std::vector<std::string> mesh_warnings(const Scene& scene, const std::vector<double>& K_I,
                                       const std::vector<double>& distance);

/// Of these what growth may bring about: no ring of three elements about a tip. `radius`: of its largest ring, mm.
/// Nothing where that is due to a bend behind it.
std::optional<std::string> room_warning(const Scene& scene, std::size_t tip, double radius);

/// Likewise of a tip close to another metal. How many of J and K are not to be trusted there: none, J, both.
int doubts_of_metal(const Scene& scene, std::size_t tip);
std::optional<std::string> metal_warning(const Scene& scene, std::size_t tip);

/// Likewise of a tip about which metal may flow: its `distance` of closure, mm, spans too few elements, for those on
/// its way are larger than the first ones.
std::optional<std::string> distance_warning(const Scene& scene, std::size_t tip, double distance);

}  // namespace stria::coarse
