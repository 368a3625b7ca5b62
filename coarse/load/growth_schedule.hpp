// When cracks grow in a load history.
#pragma once

#include "coarse/load/load_controller.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// True where a crack of this length, mm, ends the run where it would grow next.
[[nodiscard]] bool is_as_long_as_asked(const GrowthSection& growth, double a);

/// True where the cracks advance once a step of the load has been reached.
[[nodiscard]] bool grows_at(const GrowthSection& growth, const LoadStep& step);

}  // namespace stria::coarse
