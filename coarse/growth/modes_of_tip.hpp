// Both modes of a tip under loads that have been reached, as far as its faces let them through.
#pragma once

#include <vector>

#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// K of a tip at an extreme of the load, MPa sqrt(mm): nominal K_I, and what faces with friction let through of K_II;
/// NaN where no ring tells it.
struct ModesOfTip {
    double K_I = 0.0, K_II = 0.0;
    bool operator==(const ModesOfTip&) const = default;
};

/// Of a crack that friction holds: what it lets through of K_II is not nominal.
[[nodiscard]] bool is_rough(const CrackSection& crack);

/// Faces that may touch are not pressed by a K_I below zero.
[[nodiscard]] TipResult tip_with(const ModesOfTip& modes, const CrackSection& crack);

/// Nominal K of tips under loads, both modes: of faces without tractions.
[[nodiscard]] std::vector<TipResult> nominal_under(const LoadFactors& loads, std::vector<TipResult> nominal);

/// Of both modes together, one per tip, MPa sqrt(mm).
[[nodiscard]] std::vector<double> sizes_of(const std::vector<TipResult>& nominal);

/// Under loads that have been reached, with the `measured` K of each tip.
[[nodiscard]] std::vector<ModesOfTip> modes_let_through(const Scene& present, const std::vector<TipResult>& nominal,
                                                        const LoadFactors& loads,
                                                        const std::vector<TipResult>& measured);

/// The same loads on cracks that have grown since then: nominal K is that of the longer ones. What friction lets
/// through of K_II is known of the shorter ones alone.
void lengthen(std::vector<ModesOfTip>& modes, const Scene& longer, const std::vector<TipResult>& nominal,
              const LoadFactors& loads);

}  // namespace stria::coarse
