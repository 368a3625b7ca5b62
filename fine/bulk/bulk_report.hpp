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

/// How far plasticity reaches from a tip. A point belongs to the tip that is nearest to it, and to no other one.
struct PlasticExtent {
    double ever = 0.0;  // largest distance of a point that has ever yielded, mm
    double zone = 0.0;  // of one that has yielded in this half cycle, mm
    double axis = 0.0;  // of these, within 15 degrees of the line ahead, mm
};

/// Of the committed state, one per tip of the mesh.
[[nodiscard]] std::vector<PlasticExtent> plastic_extents(const Bulk& bulk);

/// Integral of the normal stress, across the line ahead, over the sector of 45 degrees to either side within a radius
/// (mm) of the tip, N; of the trial state.
[[nodiscard]] double force_ahead(const Bulk& bulk, const Tip& tip, double radius);

/// Committed, point by point.
[[nodiscard]] coupling::ZoneState state_of(const Bulk& bulk);

}  // namespace stria::fine
