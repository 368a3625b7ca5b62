// Hanging nodes as the ends of their edges lead them, on either side of the cracks.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "common/enrichment/enriched_mesh.hpp"
#include "common/fem/mesh.hpp"

namespace stria::coarse {

/// Of each hanging node, in their order. `mesh`: with the pieces of all cracks, its terms and the sides of its
/// elements. `beside`: sides of nodes of all cracks (CrackSides::of_hanging_too()).
[[nodiscard]] std::vector<TiedNode> tied_nodes(std::span<const HangingNode> hanging, const EnrichedMesh& mesh,
                                               const std::map<int, int>& beside);

}  // namespace stria::coarse
