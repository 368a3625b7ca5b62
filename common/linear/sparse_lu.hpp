// Sparse LU of a general square matrix (UMFPACK): the `monolithic` yardstick, whose contact rows are not symmetric.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "common/linear/sparse.hpp"

namespace stria {

/// P A Q = L U, kept for as many right-hand sides as there are.
class SparseLu {
public:
    /// Throws NumericalFailure where A is singular or holds what is no number.
    explicit SparseLu(const SparseMatrix& matrix);

    /// Solves A x = b with iterative refinement. Throws NumericalFailure where x is not finite.
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;

private:
    struct Free {
        void operator()(void* numeric) const;
    };

    Eigen::VectorXd scales_;  // of the columns: x = scales_ y
    SparseMatrix scaled_;     // what was factored, for the refinement
    std::unique_ptr<void, Free> numeric_;
};

}  // namespace stria
