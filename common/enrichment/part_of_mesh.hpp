// A part of a mesh seen from the whole: which unknown is which.
#pragma once

#include <vector>

#include "common/enrichment/enriched_mesh.hpp"

namespace stria {

/// Unknowns of a part (enriched_mesh.hpp: extract) in the numbering of the mesh it was taken from.
std::vector<int> whole_unknowns(const EnrichedMesh& whole, const EnrichedMesh& part);

}  // namespace stria
