// What a run says of itself where it finds no equilibrium.
#pragma once

#include <string>
#include <vector>

#include "coarse/analysis/analysis_state.hpp"
#include "coarse/equilibrium/newton.hpp"

namespace stria::coarse {

/// How far `increments` that have converged have come: to a target, at a load factor.
[[nodiscard]] std::string last_converged(int increments, const Target& reached, double load_factor,
                                         const Target& towards);

/// Figure 3 (b) has no end. `nominal`: one per tip, of the longer cracks.
[[nodiscard]] std::string faces_not_released(const LoadStep& step, const NewtonReport& report,
                                             const FaceRelease& release, const std::vector<TipResult>& nominal);

/// No part of a step from `reached` tells where a tip does what it does.
[[nodiscard]] std::string opening_load_lost(const LoadStep& step, double reached, int tip, const std::string& does);

}  // namespace stria::coarse
