// The scene of a case on a mesh with small elements about the tips, within the radius of their zones (fine.refine).
#pragma once

#include <functional>

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// Meshes a case, refines the mesh where the case asks for it, enriches and resolves. Throws CaseError. Cracks have no
/// points on straight stretches (ends_and_bends()): with them and without them a case has one answer, to the bit.
///
/// Eq. (3) takes K from the nominal solution on the unrefined mesh. Where cracks grow the mesh follows their tips
/// (tip_refinement.hpp). `before_solving`: hears of the scene on the unrefined mesh before its body is solved for that.
[[nodiscard]] Scene refined_scene(const Case& given, const std::function<void(const Scene&)>& before_solving = {});

}  // namespace stria::coarse
