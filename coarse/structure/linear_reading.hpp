// A number that is linear in the displacement of a structure's boundary and in the load factors.
#pragma once

#include <Eigen/Core>

#include "coarse/load/load_factors.hpp"

namespace stria::coarse {

/// weights . u + per_load_factor * lambda + per_case . cases + constant. What lies inside the structure is eliminated:
/// `per_load_factor` is what the load factor 1 adds to the reading with the boundary held at zero, `per_case` what a
/// factor 1 of each load case does, `constant` what the initial stress does.
struct LinearReading {
    Eigen::VectorXd weights;  // on the free places of Gamma (structure.hpp)
    double per_load_factor = 0.0;
    double constant = 0.0;
    Eigen::VectorXd per_case = {};

    /// The load factor itself.
    static LinearReading load_factor(Eigen::Index unknowns) { return {Eigen::VectorXd::Zero(unknowns), 1.0, 0.0}; }

    [[nodiscard]] double at(const Eigen::VectorXd& u, const LoadFactors& factors) const {
        double reading = weights.dot(u) + per_load_factor * factors.main + constant;
        for (Eigen::Index k = 0; k < per_case.size(); ++k) reading += per_case[k] * factors.of_case(k);
        return reading;
    }
    [[nodiscard]] bool is_load_factor() const { return weights.isZero(0.0); }
};

}  // namespace stria::coarse
