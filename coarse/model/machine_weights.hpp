// What a testing machine reads at the loaded boundary, as weights on unknowns and on reactions.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "coarse/model/forces_on_unknowns.hpp"
#include "coarse/model/supports_on_unknowns.hpp"

namespace stria::coarse {

/// Weights on all unknowns: their product with u is the mean displacement of the loaded boundary along its direction.
/// Zero where no boundary is loaded. Where the mean is left free, what the loads do work on, for they balance; of a
/// hole on which a pin presses, what this pressure does work on. `unit_force`: `forces` of `main`.
[[nodiscard]] Eigen::VectorXd weights_of_displacement(const std::optional<LoadedBoundary>& loaded, const Mesh& mesh,
                                                      const EnrichedMesh& enriched, const ForcesOnUnknowns& forces,
                                                      const Loads& main, const Eigen::VectorXd& unit_force);

/// Per prescribed unknown, the share of its reaction in the force reported: the direction of the loaded boundary. Zero
/// where forces load it, for they tell.
[[nodiscard]] Eigen::VectorXd weights_of_reactions(const std::optional<LoadedBoundary>& loaded,
                                                   const EnrichedMesh& enriched,
                                                   const std::vector<PrescribedUnknown>& prescribed);

}  // namespace stria::coarse
