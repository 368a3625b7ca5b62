// K of the tips at the extremes of the last cycle: what turns them, and what drives them behind a turn.
#pragma once

#include <vector>

#include "coarse/analysis/analysis_state.hpp"
#include "coarse/analysis/cracked_body.hpp"
#include "coarse/growth/growth_law.hpp"

namespace stria::coarse {

/// What turns the tips, one each: K of all loads together and of the initial stress, or what faces that touch leave of
/// it (directing()). Of one load alone: at a factor of 1 or -1, as its sign is.
[[nodiscard]] std::vector<TipResult> K_at_maximum(const CrackedBody& body, const ReachedExtremes& reached);

/// Likewise, of open faces. Of one load alone: none, for it keeps its ratio to the maximum wherever a tip turns.
[[nodiscard]] std::vector<TipResult> K_at_minimum(const CrackedBody& body, const ReachedExtremes& reached);

/// At the extremes themselves, whatever their loads. Faces that may touch are not pressed by a K_I below zero.
[[nodiscard]] std::vector<TipAtExtremes> K_at_extremes(const CrackedBody& body, const ReachedExtremes& reached);

/// The K that each tip may break by under loads that have been reached, with the `measured` K of each: its nominal K_I,
/// or that of a tip which K_II would turn sharply (K_at_break). What friction lets through of K_II is measured; where
/// no ring tells it, and where cracks go straight on, K_I alone counts.
[[nodiscard]] std::vector<double> K_of_break(const Scene& present, GrowthDirection direction,
                                             std::vector<TipResult> nominal, const LoadFactors& loads,
                                             const std::vector<TipResult>& measured);

}  // namespace stria::coarse
