// What a testing machine reads at the loaded boundary, as weights on unknowns and on reactions.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "coarse/model/forces_on_unknowns.hpp"
#include "coarse/model/loads/loads_of_case.hpp"
#include "coarse/model/supports_on_unknowns.hpp"

namespace stria::coarse {

/// Weights on all unknowns: their product with u is the displacement of the loaded boundary along its direction. Under
/// forces it is what they do work on there, over their resultant; where a motion that nothing holds would change that,
/// what all loads do work on over what they pull, for they balance. Of a pin of a compact specimen it is relative to
/// the other one. Where forces there balance, and where the boundary is moved, it is its mean. Zero where no boundary
/// is loaded, or nothing tells a direction.
[[nodiscard]] Eigen::VectorXd weights_of_displacement(const std::optional<LoadedBoundary>& loaded, const Mesh& mesh,
                                                      const EnrichedMesh& enriched, const ForcesOnUnknowns& forces,
                                                      const LoadsOfCase& loads);

/// Per prescribed unknown, the share of its reaction in the force reported: the direction of the loaded boundary. Zero
/// where forces load it, for they tell.
[[nodiscard]] Eigen::VectorXd weights_of_reactions(const std::optional<LoadedBoundary>& loaded,
                                                   const EnrichedMesh& enriched,
                                                   const std::vector<PrescribedUnknown>& prescribed);

}  // namespace stria::coarse
