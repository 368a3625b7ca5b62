// What several parts of the zone say of themselves as one zone would say it.
#pragma once

#include <vector>

#include "coupling/messages.hpp"

namespace stria::coupling {

/// Residuals, scales and digest of one more part; force and tangent are left to who condenses. `elements`: of the
/// whole, of each of the part's own.
void add(PatchResponse& whole, const PatchResponse& part, const std::vector<int>& elements);

/// Shares add up, extents are the largest, times those of the slowest. `rings`: of the whole, in their order.
StepReport sum_of(const std::vector<StepReport>& parts, const std::vector<Ring>& rings);

/// Leaves of a part's report what it has done so far: counts and times. The part has no element any more.
void forget_state(StepReport& report);

/// The state of one more part. `unknowns`, `elements`: of the whole, of each of the part's own.
void add(ZoneState& whole, const ZoneState& part, const std::vector<int>& unknowns, const std::vector<int>& elements);

}  // namespace stria::coupling
