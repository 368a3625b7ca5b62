// Whether back stresses follow the plastic strain in proportion, so that a return to the yield surface is exact.
#pragma once

#include <algorithm>
#include <vector>

#include "common/case/case.hpp"

namespace stria {

/// Prager's: it does not forget, and its C does not change.
[[nodiscard]] inline bool is_linear(const KinematicHardening& back_stress) {
    return back_stress.gamma == 0.0 && !back_stress.C_start;
}

[[nodiscard]] inline bool are_linear(const std::vector<KinematicHardening>& back_stresses) {
    return std::ranges::all_of(back_stresses, is_linear);
}

}  // namespace stria
