// Which way a tip turns, and its K just behind the turn.
#pragma once

#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/fracture/fracture_parameters.hpp"

namespace stria::coarse {

/// Angle from a tip's direction to the largest hoop stress, radians, within 70.6 degrees. Erdogan and Sih, J. Basic
/// Eng. 85 (1963) 519.
[[nodiscard]] double hoop_stress_angle(double K_I, double K_II);

/// K_I of a crack that has just turned by `angle`, radians, from one with the K of `before`: of the stress across its
/// new direction. Erdogan and Sih, likewise; within some percent of the exact one.
[[nodiscard]] double K_just_turned(const TipResult& before, double angle);

/// The K that a metal breaks by: K_I of the tip, or the one that it has once K_II has turned it sharply, if that is
/// more.
[[nodiscard]] double K_at_break(const TipResult& tip);

}  // namespace stria::coarse
