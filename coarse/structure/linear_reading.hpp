// A number that is linear in the displacement of a structure's boundary and in the load factor.
#pragma once

#include <Eigen/Core>

namespace stria::coarse {

/// weights . u + per_load_factor * lambda + constant. What lies inside the structure is eliminated: `per_load_factor`
/// is what the load factor 1 adds to the reading with the boundary held at zero, `constant` what the initial stress
/// does.
struct LinearReading {
    Eigen::VectorXd weights;  // on the free places of Gamma (structure.hpp)
    double per_load_factor = 0.0;
    double constant = 0.0;

    /// The load factor itself.
    static LinearReading load_factor(Eigen::Index unknowns) { return {Eigen::VectorXd::Zero(unknowns), 1.0, 0.0}; }

    [[nodiscard]] double at(const Eigen::VectorXd& u, double load_factor) const {
        return weights.dot(u) + per_load_factor * load_factor + constant;
    }
    [[nodiscard]] bool is_load_factor() const { return weights.isZero(0.0); }
};

}  // namespace stria::coarse
