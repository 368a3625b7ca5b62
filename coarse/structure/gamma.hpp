// Where structure and zone meet.
#pragma once

#include <vector>

#include "coarse/model/scene.hpp"
#include "common/index_set.hpp"

namespace stria::coarse {

/// Gamma: unknowns of the whole mesh, ascending, that a zone element sees and that a coarse element also sees, or that
/// are prescribed or reported. Where the structure would have none that can move, it has the zone's first one.
std::vector<int> gamma_of(const Scene& scene, const ElementSet& in_zone);

}  // namespace stria::coarse
