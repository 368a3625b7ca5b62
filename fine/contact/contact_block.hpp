// What the tree of fronts leaves over: the jumps at the root and the multipliers that touch, eliminated onto Gamma.
#pragma once

#include <Eigen/Core>

#include "common/linear/dense_cholesky.hpp"

namespace stria::fine {

/// Jumps j, boundary b and closed multipliers p obey
///     S_jj dj + S_jb db - B_j^T dp = l_j,   S_bj dj + S_bb db - B_b^T dp = l_b,   -B_j dj - B_b db = h.
/// With S_jj = L L^T the jumps go first, then the multipliers, whose matrix F = B_j S_jj^-1 B_j^T is positive definite:
/// every multiplier holds jumps of its own. Each load has two columns: what is due now, and what a unit of the load
/// factor adds.
class ContactBlock {
public:
    struct System {
        const Eigen::MatrixXd& stiffness;  // of (jumps, boundary)
        Eigen::Index jumps;
        Eigen::MatrixXd B;      // closed multipliers x (jumps, boundary)
        Eigen::VectorXd h;      // of the closed multipliers
        Eigen::MatrixXd loads;  // (jumps, boundary) x 2
    };
    struct Condensed {
        Eigen::MatrixXd stiffness;  // of the boundary, symmetric to the last bit
        Eigen::MatrixXd loads;      // boundary x 2
    };
    /// Throws NumericalFailure where the block is singular.
    Condensed eliminate(const System& system);

    struct Recovered {
        Eigen::VectorXd jumps, multipliers;
    };
    /// Of the last elimination: l = loads . (1, load_factor).
    [[nodiscard]] Recovered recover(const Eigen::VectorXd& boundary, double load_factor) const;

private:
    DenseCholesky jumps_, multipliers_;
    Eigen::MatrixXd jump_boundary_;        // W = L^-1 S_jb
    Eigen::MatrixXd jump_multipliers_;     // V = L^-1 B_j^T
    Eigen::MatrixXd multiplier_boundary_;  // X = L_F^-1 (B_b - V^T W)
    Eigen::MatrixXd jump_loads_;           // L^-1 l_j
    Eigen::MatrixXd multiplier_loads_;     // L_F^-1 (-h - V^T L^-1 l_j)
};

}  // namespace stria::fine
