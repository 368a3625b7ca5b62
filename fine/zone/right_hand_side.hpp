// What Newton's method has to remove from a zone.
#pragma once

#include <Eigen/Core>

#include "fine/zone/zone_system.hpp"

namespace stria::fine {

/// On all unknowns of the mesh forces, N/mm, and then on the tractions gaps, or pressures of multipliers that are open:
/// one that is open does not push any more.
[[nodiscard]] Eigen::VectorXd right_hand_side_of(const ZoneSystem& system);

}  // namespace stria::fine
