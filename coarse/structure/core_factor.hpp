// The elements of the core, with the condensed part that they lie on, factored.
#pragma once

#include <memory>

#include "coarse/structure/leaf_numbering.hpp"
#include "common/substructure/sparse_leaf.hpp"

namespace stria::coarse {

/// A factor and the matrix that it is of: the same matrix has the same factor.
struct CoreFactor {
    SparseMatrix matrix;  // lower triangle in the order of elimination, with the tangent of the part below, MPa
    int boundary;         // how many of the last unknowns are kept: the free ones of Gamma
    std::shared_ptr<const SparseLeaf> leaf;
};

/// Lower triangle of the core's stiffness plus the tangent of the part below. `of_elements`: as
/// LeafNumbering::order_elimination() returns them. `below`: may be null.
[[nodiscard]] SparseMatrix core_stiffness(const CoarseElements& elements, const IndexLists& of_elements, int unknowns,
                                          const BodyPart* below);

/// Factors the matrix, unless `known` (may be null) is of the same one to the last bit.
[[nodiscard]] std::shared_ptr<const CoreFactor> factor_core(SparseMatrix lower, int boundary,
                                                            std::shared_ptr<const CoreFactor> known);

}  // namespace stria::coarse
