// Bodies of which one answer tells all.
#pragma once

#include "coarse/structure/structure.hpp"

namespace stria::coarse {

/// One load alone acts on a body, and no initial stress.
[[nodiscard]] inline bool has_one_load(const Scene& scene) {
    return scene.case_forces.empty() && !scene.initial_stress().any();
}

/// That, and no zone: its displacement is the load factor times that of the factor 1.
[[nodiscard]] inline bool answers_in_proportion(const Structure& structure) {
    return structure.gamma().empty() && has_one_load(structure.scene());
}

}  // namespace stria::coarse
