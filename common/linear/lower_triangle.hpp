// Symmetric dense matrices of which the lower triangle is told.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "common/linear/lapack.hpp"

namespace stria {

/// Fills the upper triangle from the lower one.
inline void mirror_lower(Eigen::MatrixXd& C) {
    constexpr Eigen::Index tile = 32;  // columns and rows of a tile both stay in the first cache
    const Eigen::Index n = C.rows();
    for (Eigen::Index first = 0; first < n; first += tile) {
        for (Eigen::Index row = first; row < n; row += tile) {
            for (Eigen::Index j = first; j < std::min(first + tile, n); ++j)
                for (Eigen::Index i = std::max(row, j + 1); i < std::min(row + tile, n); ++i) C(j, i) = C(i, j);
        }
    }
}

/// C x; half of the way through memory that Eigen's product takes.
inline Eigen::VectorXd times_lower(const Eigen::MatrixXd& C, const Eigen::VectorXd& x) {
    Eigen::VectorXd product(x.size());
    if (x.size() > 0)
        lapack::symmetric_product(static_cast<int>(x.size()), 1.0, C.data(), static_cast<int>(C.rows()), x.data(),
                                  product.data());
    return product;
}

}  // namespace stria
