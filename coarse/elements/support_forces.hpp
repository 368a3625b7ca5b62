// Forces of the coarse elements at the supports. Supports are the prescribed unknowns of a scene.
#pragma once

#include "coarse/elements/coarse_elements.hpp"

namespace stria::coarse {

/// Internal force on each prescribed unknown, N/mm, in the scene's order. `u`: displacement of the whole mesh, mm.
[[nodiscard]] Eigen::VectorXd forces_on_prescribed(const CoarseElements& elements, const Eigen::VectorXd& u);

/// Load that imposed displacements put on the unknowns of the whole mesh, N/mm: minus the stiffness times these.
/// `imposed`: of the whole mesh, mm, zero but on prescribed unknowns.
[[nodiscard]] Eigen::VectorXd load_of_imposed(const CoarseElements& elements, const Eigen::VectorXd& imposed);

}  // namespace stria::coarse
