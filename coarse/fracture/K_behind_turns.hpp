// The K of tips that turn sharply as they grow, once they have: what drives them, closes their faces and breaks the
// body.
#pragma once

#include <vector>

#include "coarse/load/load_scale.hpp"

namespace stria::coarse {

// MPa sqrt(mm), one per tip.

/// Of tips that K_II turns by more than sharp_turn, K_just_turned; of others, and where nothing grows or turns,
/// largest_K_I.
[[nodiscard]] std::vector<double> largest_K_behind_turns(const Case& input, const UnitResponse& nominal,
                                                         double grown = 0.0);

/// That of the usual cycles (common_K_I): K of one load is to K of another as before the turn.
[[nodiscard]] std::vector<double> common_K_behind_turns(const Case& input, const UnitResponse& nominal,
                                                        double grown = 0.0, int passed = 0);

/// What the default distance of closure goes by, which is chosen once: largest_K_behind_turns; where nothing opens the
/// crack, largest_K.
[[nodiscard]] std::vector<double> K_of_closure(const Case& input, const UnitResponse& nominal);

}  // namespace stria::coarse
