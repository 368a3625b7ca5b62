// The scene of a case on a mesh with small elements about the tips, within the radius of their zones (fine.refine).
#pragma once

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// Meshes a case, refines the mesh where the case asks for it, enriches and resolves. Throws CaseError.
///
/// Eq. (3) takes K_I from the nominal solution on the unrefined mesh. Each refined disk goes with its tip as far as its
/// growth is planned, because elements do not change once they have a history. It holds at least the elements about the
/// tip's own, so that tip functions end within the smallest elements.
[[nodiscard]] Scene refined_scene(const Case& input);

}  // namespace stria::coarse
