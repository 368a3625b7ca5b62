// What can be said of a case before it runs: of its metals, its law of growth, its loads and its mesh.
#pragma once

#include <string>
#include <vector>

#include "coarse/load/load_scale.hpp"
#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// One sentence each. `nominal`: of the scene.
std::vector<std::string> case_warnings(const Scene& scene, const UnitResponse& nominal);

}  // namespace stria::coarse
