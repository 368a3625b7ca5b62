// K of the tips at the extremes of the last cycle: what turns them.
#pragma once

#include <vector>

#include "coarse/analysis/analysis_state.hpp"
#include "coarse/analysis/cracked_body.hpp"

namespace stria::coarse {

/// What turns the tips, one each: K of all loads together and of the initial stress, or what faces that touch leave of
/// it (directing()). Of one load alone: at a factor of 1 or -1, as its sign is.
[[nodiscard]] std::vector<TipResult> K_at_maximum(const CrackedBody& body, const ReachedExtremes& reached);

/// Likewise, of open faces. Of one load alone: none, for it keeps its ratio to the maximum wherever a tip turns.
[[nodiscard]] std::vector<TipResult> K_at_minimum(const CrackedBody& body, const ReachedExtremes& reached);

}  // namespace stria::coarse
