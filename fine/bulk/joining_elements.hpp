// Elements that join a zone, which the structure had until then.
#pragma once

#include "fine/bulk/bulk.hpp"

namespace stria::fine {

/// Of the elements that `before` lacks, in the state that has been evaluated, on all unknowns, N/mm: they push from
/// inside now as they did from outside.
[[nodiscard]] Eigen::VectorXd force_of_joining(const Bulk& bulk, const EnrichedMesh& before);

}  // namespace stria::fine
