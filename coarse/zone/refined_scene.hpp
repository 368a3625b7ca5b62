// The scene of a case on a mesh with small elements about the tips, within the radius of their zones (fine.refine).
#pragma once

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// Meshes a case, refines the mesh where the case asks for it, enriches and resolves. Throws CaseError.
///
/// Eq. (3) takes K_I from the nominal solution on the unrefined mesh. Where cracks grow the mesh follows their tips
/// (tip_refinement.hpp).
[[nodiscard]] Scene refined_scene(const Case& input);

}  // namespace stria::coarse
