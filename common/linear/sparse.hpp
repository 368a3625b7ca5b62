// Sparse matrices: assembled triplets, Eigen's compressed columns (or rows) with 32-bit indices.
#pragma once

#include <Eigen/SparseCore>

namespace stria {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;
using Triplet = Eigen::Triplet<double, int>;

}  // namespace stria
