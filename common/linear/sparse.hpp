// Sparse matrices of the structure: assembled triplets, Eigen's compressed columns with 32-bit indices.
#pragma once

#include <Eigen/SparseCore>

namespace stria {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
using Triplet = Eigen::Triplet<double, int>;

}  // namespace stria
