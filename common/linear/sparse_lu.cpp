#include "common/linear/sparse_lu.hpp"

#include <umfpack.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <string>

#include "common/error.hpp"

namespace stria {
namespace {

// Ratio of the smallest to the largest pivot of the scaled matrix below which its solution holds no digit.
constexpr double vanishing = 1e-15;

struct FreeSymbolic {
    void operator()(void* symbolic) const { umfpack_di_free_symbolic(&symbolic); }
};
/// Powers of two that bring the largest entry of each column near 1. UMFPACK scales rows only: the columns of contact
/// pressures, lengths beside stiffnesses, would leave pivots that pass for zero.
Eigen::VectorXd column_scales(const SparseMatrix& matrix) {
    Eigen::VectorXd scales = Eigen::VectorXd::Ones(matrix.cols());
    for (int column = 0; column < matrix.outerSize(); ++column) {
        double largest = 0.0;
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
            largest = std::max(largest, std::abs(entry.value()));
        }
        if (largest > 0.0 && std::isfinite(largest)) scales[column] = std::ldexp(1.0, -std::ilogb(largest));
    }
    return scales;
}

using Control = std::array<double, UMFPACK_CONTROL>;

Control settings() {
    Control control{};
    umfpack_di_defaults(control.data());
    control[UMFPACK_PRL] = 0;
    control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_AUTO;
    control[UMFPACK_SCALE] = UMFPACK_SCALE_SUM;
    control[UMFPACK_IRSTEP] = 2;
    return control;
}

void expect_ok(int status) {
    if (status == UMFPACK_OK) return;
    if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
    throw NumericalFailure("sparse LU: the matrix is singular (UMFPACK status " + std::to_string(status) + ")");
}

}  // namespace

void SparseLu::Free::operator()(void* numeric) const { umfpack_di_free_numeric(&numeric); }

SparseLu::SparseLu(const SparseMatrix& matrix)
    : scales_(column_scales(matrix)), scaled_(matrix * scales_.asDiagonal()) {
    require(matrix.rows() == matrix.cols(), "sparse LU: the matrix is not square");
    scaled_.makeCompressed();
    const int n = static_cast<int>(scaled_.rows());
    if (n == 0) return;
    const Control control = settings();
    const int *columns = scaled_.outerIndexPtr(), *rows = scaled_.innerIndexPtr();
    const double* values = scaled_.valuePtr();
    std::array<double, UMFPACK_INFO> info{};
    void* handle = nullptr;
    expect_ok(umfpack_di_symbolic(n, n, columns, rows, values, &handle, control.data(), info.data()));
    const std::unique_ptr<void, FreeSymbolic> symbolic(handle);
    const int status = umfpack_di_numeric(columns, rows, values, symbolic.get(), &handle, control.data(), info.data());
    numeric_.reset(handle);
    expect_ok(status);
    if (!(info[UMFPACK_RCOND] > vanishing)) throw NumericalFailure("sparse LU: the matrix is singular to rounding");
}

Eigen::VectorXd SparseLu::solve(const Eigen::VectorXd& right_hand_side) const {
    require(right_hand_side.size() == scaled_.rows(), "sparse LU: sizes differ");
    Eigen::VectorXd x(scaled_.rows());
    if (x.size() == 0) return x;
    std::array<double, UMFPACK_INFO> info{};
    expect_ok(umfpack_di_solve(UMFPACK_A, scaled_.outerIndexPtr(), scaled_.innerIndexPtr(), scaled_.valuePtr(),
                               x.data(), right_hand_side.data(), numeric_.get(), settings().data(), info.data()));
    if (!x.allFinite()) throw NumericalFailure("sparse LU: the solution is not finite");
    return x.cwiseProduct(scales_);
}

}  // namespace stria
