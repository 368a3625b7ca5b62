// Whether a material and its law of growth can be what is meant: a modulus typed in GPa or Pa is a lawful number.
#pragma once

#include <string>
#include <vector>

#include "common/case/case.hpp"

namespace stria::coarse {

/// One sentence for each material whose strain at yield no metal has. Where it is far below, increments are many times
/// that strain, and a run takes long; where it is far above, strains are not small. One for each that softens by more
/// than it hardens, when pulled on and on.
std::vector<std::string> material_warnings(const Case& input);

/// One sentence where a law of dK gives a rate that no crack has, most are printed for m/cycle or MPa sqrt(m); where it
/// lets no tip grow; or where its table ends before. `K`: of the cycles that growth is made of (common_K_behind_turns),
/// and `largest_K`: of all, MPa sqrt(mm), one per tip.
std::vector<std::string> rate_warnings(const Case& input, const std::vector<double>& K,
                                       const std::vector<double>& largest_K);

}  // namespace stria::coarse
