// Eq. (1): which nodes of the mesh carry which enrichment, for one position of the cracks.
#pragma once

#include <vector>

#include "coarse/enrichment/tip_enrichment.hpp"
#include "common/case/case.hpp"
#include "common/enrichment/enriched_mesh.hpp"
#include "common/fem/body_mesh.hpp"

namespace stria::coarse {

/// Nodes whose support the crack cuts in two carry a Heaviside term, those around a tip its functions. Throws CaseError
/// for cracks that the mesh cannot hold.
EnrichedMesh enrich(const BodyMesh& mesh, const std::vector<CrackSection>& cracks, const TipEnrichment& tips);

}  // namespace stria::coarse
