// Sparse LU of a general square matrix (UMFPACK): the `monolithic` yardstick, whose contact rows are not symmetric.
#pragma once

#include <Eigen/Core>

#include "common/linear/sparse.hpp"

namespace stria {

/// Solves A x = b with iterative refinement. Throws NumericalFailure where A is singular.
Eigen::VectorXd solve_general(const SparseMatrix& matrix, const Eigen::VectorXd& right_hand_side);

/// Forces one BLAS thread and no OpenMP inside CHOLMOD (docs/method.md, section 10): call once at program start.
void use_one_thread();

}  // namespace stria
