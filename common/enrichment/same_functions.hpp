// Where two enriched meshes have the same functions.
#pragma once

#include "common/enrichment/enriched_mesh.hpp"
#include "common/index_set.hpp"

namespace stria {

/// Of a node of each mesh: the same functions, and those of tips are of tips that stand as they did, to the last bit.
[[nodiscard]] bool same_functions_at(int node, const EnrichedMesh& mesh, int other_node, const EnrichedMesh& other);

/// The same elements with the same functions, whatever the places of the tips and the arc lengths: none of the
/// functions is a tip's.
[[nodiscard]] bool same_but_for_tips(const EnrichedMesh& mesh, const EnrichedMesh& other);

/// What lies along the cracks of two such meshes is as far from their first points: none of these has moved.
[[nodiscard]] bool same_arc_lengths(const EnrichedMesh& mesh, const EnrichedMesh& other);

/// Whether elements of one mesh have the same corners and functions on the other, where they have the same numbers; and
/// so do those beside them, which see some of their unknowns. None of their functions is a tip's.
[[nodiscard]] bool same_functions(const EnrichedMesh& mesh, const EnrichedMesh& other, const ElementSet& elements);

}  // namespace stria
