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

/// Under loads that have been reached, with the `measured` K of each tip.
[[nodiscard]] std::vector<ModesOfTip> modes_let_through(const Scene& present, const std::vector<TipResult>& nominal,
                                                        const LoadFactors& loads,
                                                        const std::vector<TipResult>& measured);

/// The rate behind a turn by `angle`, radians, of a tip that has stood still so far: the mean over the cycles that have
/// been noted (rate_just_turned), mm per cycle. NaN where that is not known: openings of faces that touch drive it, no
/// ring tells what friction lets through, or faces with friction are pressed where the tip is driven. Then a crack that
/// has turned is not driven by the K of faces without tractions.
[[nodiscard]] double rate_behind_turn(const GrowthSection& growth, const CrackSection& crack, const TurningModes& modes,
                                      std::size_t tip, double angle);

/// The K that each tip may break by: its K_I, or that of a tip which K_II would turn sharply (K_at_break). Where no
/// ring tells what friction lets through of K_II, and where cracks go straight on, K_I alone counts.
[[nodiscard]] std::vector<double> K_of_break(const Scene& present, GrowthDirection direction,
                                             const std::vector<ModesOfTip>& modes);

}  // namespace stria::coarse
