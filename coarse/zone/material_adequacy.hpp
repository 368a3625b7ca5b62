// Whether a material can be what is meant: a modulus typed in GPa or Pa is a lawful number.
#pragma once

#include <string>
#include <vector>

#include "common/case/case.hpp"

namespace stria::coarse {

/// One sentence for each material whose strain at yield no metal has. Where it is far below, increments are many times
/// that strain, and a run takes long; where it is far above, strains are not small.
std::vector<std::string> material_warnings(const Case& input);

}  // namespace stria::coarse
