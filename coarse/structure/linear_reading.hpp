// A number that is linear in the displacement of a structure's boundary and in the load factor.
#pragma once

#include <Eigen/Core>

namespace stria::coarse {

/// weights . u + per_load_factor * lambda. What lies inside the structure is eliminated: `per_load_factor` is the
/// reading at the load factor 1 with the boundary held at zero.
struct LinearReading {
    Eigen::VectorXd weights;  // on the free places of Gamma (structure.hpp)
    double per_load_factor = 0.0;

    /// The load factor itself.
    static LinearReading load_factor(Eigen::Index unknowns) { return {Eigen::VectorXd::Zero(unknowns), 1.0}; }

    [[nodiscard]] double at(const Eigen::VectorXd& u, double load_factor) const {
        return weights.dot(u) + per_load_factor * load_factor;
    }
    [[nodiscard]] bool is_load_factor() const { return weights.isZero(0.0); }
};

}  // namespace stria::coarse
