// How long a crack is.
#pragma once

#include "common/enrichment/enriched_mesh.hpp"

namespace stria::coarse {

/// Of the part of a crack in the body, from the mouth or a tip to its other end, mm of arc.
[[nodiscard]] double length_in_body(const EnrichedMesh& mesh, int crack);

}  // namespace stria::coarse
