// The near elements with the condensed far body on top of them, factored.
#pragma once

#include <memory>

#include "coarse/structure/leaf_numbering.hpp"
#include "common/substructure/sparse_leaf.hpp"

namespace stria::coarse {

/// A factor and the matrix that it is of: the same matrix has the same factor.
struct NearFactor {
    SparseMatrix matrix;  // lower triangle in the order of elimination, with the far body's tangent on the rim, MPa
    int boundary;         // how many of the last unknowns are kept: the free ones of Gamma
    std::shared_ptr<const SparseLeaf> leaf;
};

/// Lower triangle of the near elements' stiffness plus the far body's tangent. `of_elements`: as
/// LeafNumbering::order_elimination() returns them. `far`: may be null.
[[nodiscard]] SparseMatrix near_stiffness(const CoarseElements& elements, const IndexLists& of_elements, int unknowns,
                                          const FarBody* far);

/// Factors the matrix, unless `known` (may be null) is of the same one to the last bit.
[[nodiscard]] std::shared_ptr<const NearFactor> factor_near(SparseMatrix lower, int boundary,
                                                            std::shared_ptr<const NearFactor> known);

}  // namespace stria::coarse
