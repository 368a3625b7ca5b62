// The linear system of one Newton step on Gamma, with the load factor as an unknown.
#pragma once

#include <Eigen/LU>
#include <functional>

#include "coarse/equilibrium/condensed/gamma_states.hpp"
#include "coarse/structure/linear_reading.hpp"
#include "common/linear/dense_cholesky.hpp"
#include "common/substructure/substructure.hpp"

namespace stria::coarse {

/// A du - b dlambda = R and w . du + k dlambda = r. At a limit load A is singular along what is controlled: sigma w
/// times the second equation, added to the first, makes it definite again and changes no solution. (Load control: w =
/// 0, k = 1.)
class BorderedSystem {
public:
    /// `tangent`: makes A on the free places, MPa. Cholesky's method works in its place, without a copy: where A turns
    /// out not to be definite it is made again.
    void factor(const std::function<CondensedTangent()>& tangent, const LinearReading& controlled);

    /// With the factor last made. `residual`: R, N/mm; `off_target`: r; `load_derivative`: b.
    [[nodiscard]] GammaState solve(const Eigen::VectorXd& residual, double off_target,
                                   const Eigen::VectorXd& load_derivative, const LinearReading& controlled) const;

private:
    DenseCholesky factor_;
    Eigen::PartialPivLU<Eigen::MatrixXd> general_factor_;  // where A is not symmetric or not definite
    double sigma_ = 0.0;
    bool definite_ = false;
};

}  // namespace stria::coarse
