// The dense kernels we take from BLAS and LAPACK, column-major and in place; Fortran's names stay in this file.
// Measured against Eigen for one front (a third of it eliminated), 100 / 200 / 400 unknowns: Cholesky 13 / 67 / 430 us
// against 19 / 115 / 840, LU 29 / 160 / 980 against 35 / 230 / 1720; below 50 unknowns they are equal.
#pragma once

#include <cstddef>

// NOLINTBEGIN(readability-identifier-naming)
extern "C" {
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
void dgetrf_(const int* m, const int* n, double* a, const int* lda, int* pivots, int* info);
void dlaswp_(const int* n, double* a, const int* lda, const int* first, const int* last, const int* pivots,
             const int* increment);
void dtrsm_(const char* side, const char* uplo, const char* transpose, const char* diagonal, const int* m, const int* n,
            const double* alpha, const double* a, const int* lda, double* b, const int* ldb);
void dsyrk_(const char* uplo, const char* transpose, const int* n, const int* k, const double* alpha, const double* a,
            const int* lda, const double* beta, double* c, const int* ldc);
void dgemm_(const char* transpose_a, const char* transpose_b, const int* m, const int* n, const int* k,
            const double* alpha, const double* a, const int* lda, const double* b, const int* ldb, const double* beta,
            double* c, const int* ldc);
void dtrsv_(const char* uplo, const char* transpose, const char* diagonal, const int* n, const double* a,
            const int* lda, double* x, const int* increment);
void dgemv_(const char* transpose, const int* m, const int* n, const double* alpha, const double* a, const int* lda,
            const double* x, const int* increment_x, const double* beta, double* y, const int* increment_y);
void dsymv_(const char* uplo, const int* n, const double* alpha, const double* a, const int* lda, const double* x,
            const int* increment_x, const double* beta, double* y, const int* increment_y);
}
// NOLINTEND(readability-identifier-naming)

namespace stria::lapack {

enum class Side : char { Left = 'L', Right = 'R' };
enum class Triangle : char { Lower = 'L', Upper = 'U' };
enum class Op : char { Plain = 'N', Transposed = 'T' };
enum class Diagonal : char { General = 'N', Unit = 'U' };

template <class Flag> constexpr char letter(Flag flag) { return static_cast<char>(flag); }

/// A = L L^T in the lower triangle. Returns 0, or the number (from 1) of the first pivot that is not positive.
[[nodiscard]] inline int cholesky(int n, double* a, int stride) {
    int info = 0;
    dpotrf_("L", &n, a, &stride, &info);
    return info;
}

/// P A = L U with row interchanges. Returns 0, or the number (from 1) of the first pivot that vanished.
[[nodiscard]] inline int lu(int n, double* a, int stride, int* pivots) {
    int info = 0;
    dgetrf_(&n, &n, a, &stride, pivots, &info);
    return info;
}

/// B = P B, with the interchanges of lu().
inline void interchange_rows(int rows, int columns, double* b, int stride, const int* pivots) {
    const int one = 1;
    dlaswp_(&columns, b, &stride, &one, &rows, pivots, &one);
}

/// B (m x n) = op(T)^-1 B (Left) or B op(T)^-1 (Right).
inline void solve_triangle(Side side, Triangle triangle, Op op, Diagonal diagonal, int m, int n, const double* t,
                           int stride_t, double* b, int stride_b) {
    const char s = letter(side), u = letter(triangle), o = letter(op), d = letter(diagonal);
    const double one = 1.0;
    dtrsm_(&s, &u, &o, &d, &m, &n, &one, t, &stride_t, b, &stride_b);
}

/// B (m x n) = B L^-T, in halves down to a small triangle: products run at 1.5 times the speed of dtrsm (47 against 26
/// Gflop/s at 172 x 492).
inline void solve_lower_transposed(int m, int n, const double* l, int stride_l, double* b, int stride_b) {
    constexpr int small = 48;
    if (n <= small) {
        solve_triangle(Side::Right, Triangle::Lower, Op::Transposed, Diagonal::General, m, n, l, stride_l, b, stride_b);
        return;
    }
    const int first = (n / 2 + 7) / 8 * 8, second = n - first;
    const std::ptrdiff_t down = first, across_l = std::ptrdiff_t{first} * stride_l;
    double* rest = b + std::ptrdiff_t{first} * stride_b;
    solve_lower_transposed(m, first, l, stride_l, b, stride_b);
    const char plain = letter(Op::Plain), transposed = letter(Op::Transposed);
    const double minus = -1.0, one = 1.0;
    dgemm_(&plain, &transposed, &m, &second, &first, &minus, b, &stride_b, l + down, &stride_l, &one, rest, &stride_b);
    solve_lower_transposed(m, second, l + across_l + down, stride_l, rest, stride_b);
}

/// x = op(T)^-1 x.
inline void solve_triangle(Triangle triangle, Op op, Diagonal diagonal, int n, const double* t, int stride, double* x) {
    const char u = letter(triangle), o = letter(op), d = letter(diagonal);
    const int one = 1;
    dtrsv_(&u, &o, &d, &n, t, &stride, x, &one);
}

/// Lower triangle of C (n x n) = beta C + alpha A A^T, A of n x k.
inline void add_square(int n, int k, double alpha, const double* a, int stride_a, double beta, double* c,
                       int stride_c) {
    dsyrk_("L", "N", &n, &k, &alpha, a, &stride_a, &beta, c, &stride_c);
}

/// C (m x n) -= A B, A of m x k.
inline void subtract_product(int m, int n, int k, const double* a, int stride_a, const double* b, int stride_b,
                             double* c, int stride_c) {
    const double minus = -1.0, one = 1.0;
    dgemm_("N", "N", &m, &n, &k, &minus, a, &stride_a, b, &stride_b, &one, c, &stride_c);
}

/// y -= op(A) x, A of m x n.
inline void subtract_product(Op op, int m, int n, const double* a, int stride, const double* x, double* y) {
    const char o = letter(op);
    const double minus = -1.0, plus = 1.0;
    const int one = 1;
    dgemv_(&o, &m, &n, &minus, a, &stride, x, &one, &plus, y, &one);
}

/// y = alpha A x, A symmetric by its lower triangle.
inline void symmetric_product(int n, double alpha, const double* a, int stride, const double* x, double* y) {
    const char lower = letter(Triangle::Lower);
    const double none = 0.0;
    const int step = 1;
    dsymv_(&lower, &n, &alpha, a, &stride, x, &step, &none, y, &step);
}

}  // namespace stria::lapack
