// Structures one after another, each with what serves of the last one's factors.
#pragma once

#include <memory>

#include "coarse/structure/structure.hpp"
#include "coupling/work_counts.hpp"

namespace stria::coarse {

/// `factors`: of the last one, and then of this. `work`: counts what has been assembled and factored below the core.
[[nodiscard]] std::unique_ptr<Structure> condense(const Scene& scene, const ElementSet& in_zone,
                                                  const StillElements& still, StructureFactors& factors,
                                                  coupling::WorkCounts& work);

}  // namespace stria::coarse
