// What can be said of a case before it runs: of its metals, its law of growth, its loads and its mesh.
#pragma once

#include <string>
#include <vector>

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// One sentence each. `K`: of the cycles that opening loads are asked of, MPa sqrt(mm), one per tip (common_K_I).
std::vector<std::string> case_warnings(const Scene& scene, const std::vector<double>& K);

}  // namespace stria::coarse
