// Eq. (1): which nodes of the mesh carry which enrichment, for one position of the cracks.
#pragma once

#include "common/fem/crack_path.hpp"
#include "common/fem/enriched_mesh.hpp"
#include "common/io/case.hpp"

namespace stria::coarse {

struct TipEnrichment {
    int functions = 6;  // 6: eq. (2); 1: r^(1/2) sin(theta/2); 0: none, the crack ends on the last edge before its tip
    double exponent = 0.5;  // 1/(n+1)
};

/// `auto`: six functions with n = 1 in elastic scenes, the single function with plasticity (NUMERICS 2).
TipEnrichment choose_enrichment(const Case& input);

/// Nodes whose support the crack cuts in two carry a Heaviside term, those of the elements that hold a tip the tip
/// functions (topological enrichment). Throws CaseError for cracks that the mesh cannot hold.
EnrichedMesh enrich(const Mesh& mesh, const std::vector<CrackSection>& cracks, const TipEnrichment& tips);

}  // namespace stria::coarse
