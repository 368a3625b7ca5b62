// Forces of the coarse elements at the supports. Supports are the prescribed unknowns of a scene.
#pragma once

#include "coarse/elements/coarse_elements.hpp"

namespace stria::coarse {

/// Internal force on each prescribed unknown, N/mm, in the scene's order. `u`: displacement of the whole mesh, mm.
[[nodiscard]] Eigen::VectorXd forces_on_prescribed(const CoarseElements& elements, const Eigen::VectorXd& u);

/// Of outer forces on all unknowns, what acts on each prescribed one, N/mm, in the scene's order: it balances a part of
/// the internal force there, which no support bears.
[[nodiscard]] Eigen::VectorXd loads_on_prescribed(const Scene& scene, const Eigen::VectorXd& load);

/// Load that imposed displacements put on the unknowns of the whole mesh, N/mm: minus the stiffness times these.
/// `imposed`: of the whole mesh, mm, zero but on prescribed unknowns.
[[nodiscard]] Eigen::VectorXd load_of_imposed(const CoarseElements& elements, const Eigen::VectorXd& imposed);

}  // namespace stria::coarse
