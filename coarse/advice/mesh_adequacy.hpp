// Whether the mesh at the tips is fine enough for opening loads and growth: said before a run, not found out after it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// One sentence per region whose outline elements do not follow; per tip less than two elements from a bend behind it,
/// or about which no ring of three elements lies, or, of several materials, none of four in its own; per tip whose
/// forward zone spans fewer than five elements where contact is asked for, or, straight ahead, five in plane strain and
/// ten in plane stress where it grows, with the `fine.refine` that would do; per tip whose distance of closure spans
/// fewer than 1.2 elements; per tip that grows by two elements or more, or by one and a part, at a time, or in plane
/// stress by more than a tenth of its zone and beyond the distance of closure; per tip that grows by its closure in
/// plane strain; one for functions that stand at tips with elements small enough for none because others have larger
/// ones; and per tip that grows between faces that may touch where nothing yields, and leaves functions
/// behind. `K_I`, MPa sqrt(mm), of the cycles that opening loads are asked of (common_K_I), `distance`, mm, of closure
/// (closure_distances): one per tip. Of zones nothing where nothing flows.
std::vector<std::string> mesh_warnings(const Scene& scene, const std::vector<double>& K_I,
                                       const std::vector<double>& distance);

/// Of these what growth may bring about: no ring of three elements about a tip. `radius`: of its largest ring, mm.
/// Nothing where that is due to a bend behind it.
std::optional<std::string> room_warning(const Scene& scene, std::size_t tip, double radius);

}  // namespace stria::coarse
