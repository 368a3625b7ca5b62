// What several parts of the zone say of themselves as one zone would say it.
#pragma once

#include <vector>

#include "coupling/messages.hpp"

namespace stria::coupling {

/// Residuals, scales and digest of the whole; force and tangent are left to who condenses. `elements`: of each part,
/// the element of the whole of each of its own, `count` in all.
PatchResponse merge(const std::vector<PatchResponse>& parts, const std::vector<std::vector<int>>& elements, int count);

/// Shares add up, extents are the largest, times those of the slowest. `rings`: of the whole, in their order.
StepReport merge(const std::vector<StepReport>& parts, const std::vector<Ring>& rings);

/// Appends a part's state. `unknowns`, `elements`: of the whole, of each of the part's own.
void append(ZoneState& whole, const ZoneState& part, const std::vector<int>& unknowns,
            const std::vector<int>& elements);

}  // namespace stria::coupling
