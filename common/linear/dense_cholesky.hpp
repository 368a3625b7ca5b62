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

    /// L^-1 b.
    [[nodiscard]] Eigen::MatrixXd forward(Eigen::MatrixXd b) const { return solved(lapack::Op::Plain, std::move(b)); }

    /// L^-T b.
    [[nodiscard]] Eigen::MatrixXd backward(Eigen::MatrixXd b) const {
        return solved(lapack::Op::Transposed, std::move(b));
    }

    [[nodiscard]] Eigen::MatrixXd solve(Eigen::MatrixXd b) const { return backward(forward(std::move(b))); }

    [[nodiscard]] int size() const { return static_cast<int>(lower_.rows()); }

private:
    [[nodiscard]] Eigen::MatrixXd solved(lapack::Op op, Eigen::MatrixXd b) const {
        if (b.size() > 0) {
            lapack::solve_triangle(lapack::Side::Left, lapack::Triangle::Lower, op, lapack::Diagonal::General, size(),
                                   static_cast<int>(b.cols()), lower_.data(), size(), b.data(), size());
        }
        return b;
    }

    Eigen::MatrixXd lower_;
};

/// Lower triangle of C += sign A^T A.
inline void add_square_of_transposed(Eigen::MatrixXd& C, double sign, const Eigen::MatrixXd& A) {
    if (A.size() == 0) return;
    const int n = static_cast<int>(C.rows()), k = static_cast<int>(A.rows());
    lapack::add_square_of_transposed(n, k, sign, A.data(), k, 1.0, C.data(), n);
}

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
