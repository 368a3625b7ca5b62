// How many points the elements of a zone have: asked where they are placed, and before a run.
#pragma once

#include "common/case/case.hpp"
#include "common/enrichment/enriched_mesh.hpp"
#include "common/integration/element_points.hpp"

namespace stria {

/// `may_yield`: some metal does. Points of elastic elements have no history, so there may be many about a tip.
[[nodiscard]] IntegrationRule zone_rule(const FineSection& fine, bool may_yield);

/// Whether a tip may come to an element of this centre and diagonal, mm, or has just left it, if it goes straight on,
/// or nearly. Elements of which none may have far_subcells.
[[nodiscard]] bool lies_on_way(const Tip& tip, const Vec2& centre, double diagonal);
[[nodiscard]] bool lies_on_way_of_a_tip(const EnrichedMesh& mesh, int element);

/// The points that a zone places in an element, as long as none is known from before; nearly so where it has more than
/// 8 x 8 sub-quadrangles. `cut`: the crack inside the element, or null.
[[nodiscard]] int points_of_zone(const EnrichedMesh& mesh, int element, const CrackPiece* cut,
                                 const IntegrationRule& rule);

}  // namespace stria
