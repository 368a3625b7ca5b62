// Where fine.refine asks for small elements: about every tip, within the radius of its zone.
#pragma once

#include <vector>

#include "coarse/model/mesh_refinement.hpp"
#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// Of a scene whose mesh is not split yet. Eq. (3) takes K_I from its elastic solution; a disk holds at least the
/// elements about the tip's own, so that tip functions end within the smallest, and goes with the tip as far as its
/// growth is planned: elements do not change once they have a history.
std::vector<RefinedDisk> disks_to_refine(const Scene& scene);

}  // namespace stria::coarse
