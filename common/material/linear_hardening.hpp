// Whether back stresses follow the plastic strain in proportion, so that a return to the yield surface is exact.
#pragma once

#include <algorithm>
#include <vector>

#include "common/case/case.hpp"

namespace stria {

/// Prager's: none forgets, and no C changes.
[[nodiscard]] inline bool are_linear(const std::vector<KinematicHardening>& back_stresses) {
    return std::ranges::all_of(back_stresses,
                               [](const KinematicHardening& term) { return term.gamma == 0.0 && !term.C_start; });
}

}  // namespace stria
