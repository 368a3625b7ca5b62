// K of the tips at the extremes of the last cycle: what turns them.
#pragma once

#include <vector>

#include "coarse/analysis/analysis_state.hpp"
#include "coarse/analysis/cracked_body.hpp"
#include "coarse/cycle/increment.hpp"

namespace stria::coarse {

/// An increment has reached the maximum of a cycle; its minimum.
void note_maximum(ReachedExtremes& extremes, const LoadFactors& loads, const Increment& reached);
void note_minimum(ReachedExtremes& extremes, const LoadFactors& loads, const Increment& reached);

/// Nominal K of the tips, one each: of all loads together and of the initial stress. Of one load alone: at a factor of
/// 1 or -1, as its sign is.
[[nodiscard]] std::vector<TipResult> K_at_maximum(const CrackedBody& body, const ReachedExtremes& reached);

/// What turns the tips: that, or what faces that touch make of it (directing()). One load alone that is not above
/// zero at its maximum turns them by what they have at its minimum, where it is largest: a crack that is pressed and
/// let go has nothing at its maximum, or what friction has kept.
[[nodiscard]] std::vector<TipResult> K_that_turns(const CrackedBody& body, const ReachedExtremes& reached);

/// Nominal K at the minimum. Of one load alone: none, for it keeps its ratio to the maximum wherever a tip turns.
[[nodiscard]] std::vector<TipResult> K_at_minimum(const CrackedBody& body, const ReachedExtremes& reached);

}  // namespace stria::coarse
