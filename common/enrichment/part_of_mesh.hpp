// A part of a mesh: cut out of the whole, and which of its unknowns is which of the whole.
#pragma once

#include <vector>

#include "common/enrichment/enriched_mesh.hpp"

namespace stria {

/// The part of a mesh made of the given elements (ascending), with their pieces, all tips, and the terms of their nodes
/// that do not vanish on all of them. With a hanging node it must hold the ends of its edge.
EnrichedMesh extract(const EnrichedMesh& whole, const std::vector<int>& elements);

/// Unknowns of a part in the numbering of the mesh it was taken from.
std::vector<int> whole_unknowns(const EnrichedMesh& whole, const EnrichedMesh& part);

}  // namespace stria
