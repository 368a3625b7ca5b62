// A dense symmetric positive definite system by LAPACK (lapack.hpp): what is left once everything sparse is condensed.
#pragma once

#include <Eigen/Core>
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

}  // namespace stria
