// Tip functions of tips that have moved on, kept as unknowns (growth.retain).
#pragma once

#include "common/enrichment/enriched_mesh.hpp"

namespace stria::coarse {

/// The mesh of longer cracks, with the tip functions of `before`, the same nodes with its cracks shorter, but for those
/// of a tip that is nearly where it was. The unknowns are numbered anew.
[[nodiscard]] EnrichedMesh with_functions_left(EnrichedMesh mesh, const EnrichedMesh& before);

}  // namespace stria::coarse
