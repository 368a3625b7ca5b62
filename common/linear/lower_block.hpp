// Some rows and columns of a symmetric sparse matrix.
#pragma once

#include <vector>

#include "common/index.hpp"
#include "common/linear/sparse.hpp"

namespace stria {

/// The lower triangle of the rows and columns `kept`. They come in rising order, so that the rows of a column stay
/// sorted.
inline SparseMatrix lower_block(const SparseMatrix& matrix, const std::vector<int>& kept) {
    std::vector<int> number(at(static_cast<int>(matrix.rows())), -1);
    for (int i = 0; i < static_cast<int>(kept.size()); ++i) number[at(kept[at(i)])] = i;
    SparseMatrix block(std::ssize(kept), std::ssize(kept));
    block.reserve(matrix.nonZeros() / 2 + matrix.rows());
    for (int column = 0; column < block.outerSize(); ++column) {
        block.startVec(column);
        for (SparseMatrix::InnerIterator entry(matrix, kept[at(column)]); entry; ++entry) {
            const int row = number[at(entry.index())];
            if (row >= column) block.insertBack(row, column) = entry.value();
        }
    }
    block.finalize();
    return block;
}

}  // namespace stria
