// Whether what begins and ends growth can be what is meant: a K typed in MPa sqrt(m) is a lawful number.
#pragma once

#include <string>
#include <vector>

#include "common/case/case.hpp"

namespace stria::coarse {

/// One sentence for each of growth.threshold and growth.toughness that no metal has, and what it is if it is meant in
/// MPa sqrt(m).
std::vector<std::string> units_of_K_warnings(const Case& input);

/// One sentence where growth.toughness is reached before a crack has grown. `K`: the largest K_I of the load history,
/// `turned`: what it is behind a sharp turn, else the same; MPa sqrt(mm), one per tip each.
std::vector<std::string> early_break_warnings(const Case& input, const std::vector<double>& K,
                                              const std::vector<double>& turned);

}  // namespace stria::coarse
