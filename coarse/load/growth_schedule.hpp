// When cracks grow in a load history, and how far in a whole run.
#pragma once

#include "coarse/load/load_controller.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// True where the cracks advance once a step of the load has been reached.
[[nodiscard]] bool grows_at(const GrowthSection& growth, const LoadStep& step);

/// What a tip advances in a whole run, mm.
[[nodiscard]] double planned_growth(const GrowthSection& growth, const LoadSection& load);

}  // namespace stria::coarse
