// The K by which tips may break.
#pragma once

#include <vector>

#include "coarse/growth/modes_of_tip.hpp"

namespace stria::coarse {

/// The largest K of a tip since it has grown, MPa sqrt(mm): by which it may break, and nominal K_I.
struct ReachedK {
    double of_break = 0.0, K_I = 0.0;
    bool operator==(const ReachedK&) const = default;
};

/// The K that each tip may break by: its K_I, or that of a tip which K_II would turn sharply (K_at_break). Where no
/// ring tells what friction lets through of K_II, and where cracks go straight on, K_I alone counts.
[[nodiscard]] std::vector<double> K_of_break(const Scene& present, GrowthDirection direction,
                                             const std::vector<ModesOfTip>& modes);

}  // namespace stria::coarse
