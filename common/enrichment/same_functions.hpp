// Where two enriched meshes have the same functions.
#pragma once

#include "common/enrichment/enriched_mesh.hpp"
#include "common/index_set.hpp"

namespace stria {

/// Whether elements of one mesh have the same corners and functions on the other, where they have the same numbers; and
/// so do those beside them, which see some of their unknowns. None of their functions is a tip's.
[[nodiscard]] bool same_functions(const EnrichedMesh& mesh, const EnrichedMesh& other, const ElementSet& elements);

}  // namespace stria
