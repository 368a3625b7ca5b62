// What the zone's answer says of the residual, for every way in which equilibrium is found.
#pragma once

#include "coarse/equilibrium/equilibrium.hpp"
#include "coupling/messages.hpp"

namespace stria::coarse {

/// Writes the zone's residuals and the sums of its digest; the scale grows to the zone's forces.
void add_zone(Residual& residual, const coupling::PatchResponse& response);

}  // namespace stria::coarse
