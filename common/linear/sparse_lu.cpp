#include "common/linear/sparse_lu.hpp"

#include <dlfcn.h>
#include <umfpack.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "common/error.hpp"

namespace stria {
namespace {

// Ratio of the smallest to the largest pivot of the scaled matrix below which its solution holds no digit.
constexpr double vanishing = 1e-15;

struct FreeSymbolic {
    void operator()(void* symbolic) const { umfpack_di_free_symbolic(&symbolic); }
};
struct FreeNumeric {
    void operator()(void* numeric) const { umfpack_di_free_numeric(&numeric); }
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

void expect_ok(int status) {
    if (status == UMFPACK_OK) return;
    throw NumericalFailure("sparse LU: the matrix is singular (UMFPACK status " + std::to_string(status) + ")");
}

template <class... Arguments> void call_if_present(const char* symbol, Arguments... arguments) {
    if (void* found = dlsym(RTLD_DEFAULT, symbol)) reinterpret_cast<void (*)(Arguments...)>(found)(arguments...);
}

}  // namespace

Eigen::VectorXd solve_general(const SparseMatrix& matrix, const Eigen::VectorXd& right_hand_side) {
    require(matrix.rows() == matrix.cols() && matrix.rows() == right_hand_side.size(), "sparse LU: sizes differ");
    const int n = static_cast<int>(matrix.rows());
    if (n == 0) return {};
    const Eigen::VectorXd scales = column_scales(matrix);
    SparseMatrix scaled = matrix * scales.asDiagonal();
    scaled.makeCompressed();
    const int* columns = scaled.outerIndexPtr();
    const int* rows = scaled.innerIndexPtr();

    std::array<double, UMFPACK_CONTROL> control{};
    std::array<double, UMFPACK_INFO> info{};
    umfpack_di_defaults(control.data());
    control[UMFPACK_PRL] = 0;
    control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_AUTO;
    control[UMFPACK_SCALE] = UMFPACK_SCALE_SUM;
    control[UMFPACK_IRSTEP] = 2;

    void* handle = nullptr;
    expect_ok(umfpack_di_symbolic(n, n, columns, rows, scaled.valuePtr(), &handle, control.data(), info.data()));
    const std::unique_ptr<void, FreeSymbolic> symbolic(handle);
    const int status =
        umfpack_di_numeric(columns, rows, scaled.valuePtr(), symbolic.get(), &handle, control.data(), info.data());
    const std::unique_ptr<void, FreeNumeric> numeric(handle);
    expect_ok(status);
    if (!(info[UMFPACK_RCOND] > vanishing)) throw NumericalFailure("sparse LU: the matrix is singular to rounding");

    Eigen::VectorXd x(n);
    expect_ok(umfpack_di_solve(UMFPACK_A, columns, rows, scaled.valuePtr(), x.data(), right_hand_side.data(),
                               numeric.get(), control.data(), info.data()));
    if (!x.allFinite()) throw NumericalFailure("sparse LU: the solution is not finite");
    return x.cwiseProduct(scales);
}

void use_one_thread() {
    // Both symbols are absent with the reference BLAS and without OpenMP: then there is nothing to stop.
    call_if_present("openblas_set_num_threads", 1);
    call_if_present("omp_set_max_active_levels", 0);
}

}  // namespace stria
