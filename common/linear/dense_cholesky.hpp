// A dense symmetric positive definite system by LAPACK (lapack.hpp): what is left once everything sparse is condensed.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <utility>

#include "common/linear/lapack.hpp"

namespace stria {

/// A = L L^T. Sizes of zero are allowed.
class DenseCholesky {
public:
    /// Reads the lower triangle. False where A is not positive definite: then only factor() may be called.
    [[nodiscard]] bool factor(Eigen::MatrixXd lower) {
        lower_ = std::move(lower);
        return size() == 0 || lapack::cholesky(size(), lower_.data(), size()) == 0;
    }

    [[nodiscard]] Eigen::MatrixXd solve(Eigen::MatrixXd b) const {
        for (const lapack::Op op : {lapack::Op::Plain, lapack::Op::Transposed}) solve_triangle(op, b);
        return b;
    }

    [[nodiscard]] int size() const { return static_cast<int>(lower_.rows()); }

private:
    void solve_triangle(lapack::Op op, Eigen::MatrixXd& b) const {
        if (b.size() == 0) return;
        lapack::solve_triangle(lapack::Side::Left, lapack::Triangle::Lower, op, lapack::Diagonal::General, size(),
                               static_cast<int>(b.cols()), lower_.data(), size(), b.data(), size());
    }

    Eigen::MatrixXd lower_;
};

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

}  // namespace stria
