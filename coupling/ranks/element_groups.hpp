// Elements of the zone that one fine rank must own together.
#pragma once

#include <vector>

#include "common/enrichment/enriched_mesh.hpp"

namespace stria::coupling {

struct ElementGroup {
    std::vector<int> elements;
    Vec2 centre = Vec2::Zero();  // mean of the elements'
    int rank = -1;
};

/// All elements: those that see jump or tip unknowns of a crack, or carry pieces of it, in `zone` or in `before` (may
/// be empty); those around a hanging node with the ends of its edge; those that are parts of one that has been split
/// (`part_of` as in Patch).
std::vector<ElementGroup> element_groups(const EnrichedMesh& zone, const EnrichedMesh& before,
                                         const std::vector<int>& part_of);

/// The same, and with a crack go the elements that it cuts next if it goes straight on: then it comes to elements of
/// another rank seldom.
std::vector<ElementGroup> element_groups_with_ways(const EnrichedMesh& zone, const EnrichedMesh& before,
                                                   const std::vector<int>& part_of);

}  // namespace stria::coupling
