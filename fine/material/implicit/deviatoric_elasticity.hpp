// Elasticity as deviators of plane problems see it.
#pragma once

#include "common/material/elasticity.hpp"
#include "fine/material/implicit/plane_deviators.hpp"

namespace stria::fine {

struct DeviatoricElasticity {
    MandelMatrix stiffness;
    Eigen::Matrix<double, 3, 4> on_deviators;  // MPa: dev(C : eps) of a strain
    Eigen::Array3d rates;                      // MPa: dev(C : e) of a deviator e, which is diagonal

    explicit DeviatoricElasticity(const Elasticity& elasticity)
        : stiffness(elasticity.stiffness()), on_deviators(deviator_basis() * stiffness),
          rates((on_deviators * deviator_basis().transpose()).diagonal()) {}

    /// C : eps for every point of a pack.
    template <int rows> [[nodiscard]] Tensors<rows> stress(const Tensors<rows>& strain) const {
        return (strain.matrix() * stiffness).array();
    }
};

}  // namespace stria::fine
