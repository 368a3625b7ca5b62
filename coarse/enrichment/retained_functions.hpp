// Tip functions of tips that have moved on, kept as unknowns (growth.retain).
#pragma once

#include <vector>

#include "common/enrichment/enriched_mesh.hpp"

namespace stria::coarse {

/// So many edges of its element a tip has to move. Functions of tips that are nearer say next to the same: over some
/// elements in steps of a fifth of one the condition of the equations is 1e9 with six functions, of a tenth 1e15
/// (verification.RetainedFunctions).
constexpr double apart_to_retain = 0.22;

/// The mesh of longer cracks, with the tip functions of `before`, the same nodes with its cracks shorter, but for those
/// of a tip that is nearly where it was. The unknowns are numbered anew.
[[nodiscard]] EnrichedMesh with_functions_left(EnrichedMesh mesh, const EnrichedMesh& before);

/// The tips of longer cracks that have moved, and not far enough for their functions of `before` to be kept.
[[nodiscard]] std::vector<int> tips_nearly_where_they_were(const EnrichedMesh& mesh, const EnrichedMesh& before);

}  // namespace stria::coarse
