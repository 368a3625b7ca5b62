// When cracks grow in a load history.
#pragma once

#include "coarse/load/load_controller.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// True where the cracks advance once a step of the load has been reached.
[[nodiscard]] bool grows_at(const GrowthSection& growth, const LoadStep& step);

}  // namespace stria::coarse
