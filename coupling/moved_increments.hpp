// Where cracks have grown: the increments to predict from, moved along with the tips.
#pragma once

#include <functional>

#include "coupling/messages.hpp"

namespace stria::coupling {

/// Nothing where the mesh about a tip has no such move. `increments`: on all unknowns of `before`, mm, a column each;
/// asked for only where they are wanted.
[[nodiscard]] MovedIncrements moved_increments(const EnrichedMesh& before, const EnrichedMesh& next,
                                               const std::function<Eigen::MatrixXd()>& increments);

}  // namespace stria::coupling
