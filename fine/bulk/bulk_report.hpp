// What is reported of the bulk: integrals over it, how far plasticity reaches, and the state of its points.
#pragma once

#include "common/fracture/domain_integral.hpp"
#include "coupling/messages.hpp"
#include "fine/bulk/bulk.hpp"

namespace stria::fine {

/// Integrals of the committed state, N (per mm of thickness).
[[nodiscard]] double dissipation(const Bulk& bulk);
[[nodiscard]] double stored_energy(const Bulk& bulk);

/// Adds the committed bulk's share to the domain integrals of a tip.
void add_to(RingSums& rings, const Bulk& bulk);

/// Largest distance from the tip to a point that has ever yielded, mm.
[[nodiscard]] double plastic_reach(const Bulk& bulk, const Tip& tip);

/// Largest distance from the tip to a point that has yielded in this half cycle, mm; among those whose angle to the
/// line ahead is at most `half_angle`.
[[nodiscard]] double plastic_extent(const Bulk& bulk, const Tip& tip, double half_angle);

/// Integral of the normal stress, across the line ahead, over the sector of 45 degrees to either side within a radius
/// (mm) of the tip, N; of the trial state.
[[nodiscard]] double force_ahead(const Bulk& bulk, const Tip& tip, double radius);

/// Committed, point by point.
[[nodiscard]] coupling::ZoneState state_of(const Bulk& bulk);

}  // namespace stria::fine
