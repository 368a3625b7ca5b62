// Where structure and zone meet.
#pragma once

#include <vector>

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// Gamma: unknowns of the whole mesh that zone elements share with coarse ones or that are prescribed or reported,
/// ascending. `in_zone`: per element.
std::vector<int> gamma_of(const Scene& scene, const std::vector<char>& in_zone);

}  // namespace stria::coarse
