// Bodies of which one answer tells all.
#pragma once

#include "coarse/structure/structure.hpp"

namespace stria::coarse {

/// One load alone acts on it, and no zone or initial stress: its displacement is the load factor times that of the
/// factor 1.
[[nodiscard]] inline bool answers_in_proportion(const Structure& structure) {
    const Scene& scene = structure.scene();
    return structure.gamma().empty() && scene.case_forces.empty() && !scene.initial_stress().any();
}

}  // namespace stria::coarse
