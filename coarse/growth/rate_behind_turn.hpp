// What drives a tip behind a turn that K_II makes of it, where K_I alone does not.
#pragma once

#include <cstddef>
#include <vector>

#include "coarse/growth/modes_of_tip.hpp"

namespace stria::coarse {

/// What would drive tips behind a turn: at the last minimum, one per tip; and for each cycle since they have grown
/// those of its maximum, then those of its minimum.
struct TurningModes {
    std::vector<ModesOfTip> minimum, cycles;
};

/// The rate behind a turn by `angle`, radians, of a tip that has stood still so far: the mean over the cycles that have
/// been noted (rate_just_turned), mm per cycle. NaN where that is not known: openings of faces that touch drive it, no
/// ring tells what friction lets through, or faces with friction are pressed where the tip is driven. Then a crack that
/// has turned is not driven by the K of faces without tractions.
[[nodiscard]] double rate_behind_turn(const GrowthSection& growth, const CrackSection& crack, const TurningModes& modes,
                                      std::size_t tip, double angle);

}  // namespace stria::coarse
