// Assembly of a symmetric sparse matrix without triplets: the pattern from the elements' unknowns, then the values.
#pragma once

#include <Eigen/Core>
#include <span>

#include "common/index_lists.hpp"
#include "common/linear/sparse.hpp"

namespace stria {

/// Lower triangle, zero, with a place for every pair of unknowns that meet in an element; -1 in the lists: no unknown.
SparseMatrix lower_pattern(const IndexLists& element_unknowns, int unknowns);

/// Adds the lower triangle of an element's symmetric matrix. Each pair must have a place.
void add_to_lower(SparseMatrix& lower, std::span<const int> unknowns, const Eigen::Ref<const Eigen::MatrixXd>& matrix);

}  // namespace stria
