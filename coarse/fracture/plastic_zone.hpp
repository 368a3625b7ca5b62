// How far metal flows about a tip, by formulas: each length answers a question of its own.
#pragma once

#include <vector>

#include "common/case/case.hpp"

namespace stria::coarse {

// Lengths are mm, K is MPa sqrt(mm), yield stresses are MPa.

/// Eq. (3): R_sub = beta * (pi/16) * K^2 / sigma_y^2, which element is fine. `K`: largest_K (load_scale.hpp).
double subdivision_radius(double beta, double K, double yield_stress);

/// How far behind each tip closure and the opening are looked at: as the case says, or a tenth of eq. (3) where beta is
/// 1. `K`: K_of_closure (K_behind_turns.hpp); one per tip like `yield_stress`.
[[nodiscard]] std::vector<double> closure_distances(const ClosureSection& closure, const std::vector<double>& K,
                                                    const std::vector<double>& yield_stress);

/// Largest extent of the flow about a tip at its largest load, in whatever direction: (K / sigma_y)^2 / pi in plane
/// stress (Irwin), 0.157 (K / sigma_y)^2 in plane strain, at 71 degrees to the crack (Levy et al., Int. J. Fracture
/// Mech. 7, 1971). Zero under pressure.
double forward_zone(double K_I, double yield_stress, PlaneState plane);

/// Its extent straight ahead of a tip that grows: the same in plane stress, 0.04 (K / sigma_y)^2 in plane strain
/// (measured: docs/verification/closure.md). There the faces close that a growing tip leaves.
double forward_zone_ahead(double K_I, double yield_stress, PlaneState plane);

/// At most that far ahead of a tip the elastic stresses reach yield: as far as forward_zone() in plane stress, 0.47
/// times as far in plane strain with nu = 0.3, where metal flows to the sides. So more than forward_zone_ahead().
double elastic_zone_ahead(double K_I, double yield_stress, PlaneState plane);

}  // namespace stria::coarse
