#include "common/substructure/front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/index.hpp"
#include "common/linear/lapack.hpp"
#include "common/linear/lower_triangle.hpp"

namespace stria {
namespace {

using lapack::Diagonal;
using lapack::Op;
using lapack::Side;
using lapack::Triangle;

auto size_of(int count) { return at(count); }

bool vanishes(double pivot, double scale, double tolerance) {
    return !(pivot > tolerance * scale) || !std::isfinite(pivot);
}

}  // namespace

Front::Front(int eliminated, int multipliers, int kept)
    : eliminated_(eliminated), multipliers_(multipliers), kept_(kept), stride_(std::max(1, eliminated + kept)),
      panel_(eliminated + kept, eliminated), schur_(kept, kept), scale_(eliminated) {}

void Front::clear(Symmetry symmetry) {
    symmetry_ = symmetry;
    if (symmetric()) {
        for (int i = 0; i < eliminated_; ++i) panel_.col(i).tail(eliminated_ + kept_ - i).setZero();
        for (int i = 0; i < kept_; ++i) schur_.col(i).tail(kept_ - i).setZero();
    } else {
        panel_.setZero();
        upper_.setZero(eliminated_, kept_);
        schur_.setZero();
    }
}

double* Front::entry(int row, int column) {
    if (column < eliminated_) return &panel_(row, column);
    if (row < eliminated_) return &upper_(row, column - eliminated_);
    return &schur_(row - eliminated_, column - eliminated_);
}

void Front::add(const Eigen::MatrixXd& contribution, const Placement& placement) {
    std::span<const Placement::Run> rows(placement.runs);
    for (const Placement::Run& columns : placement.runs) {
        for (int j = 0; j < columns.length; ++j) {
            const double* column = contribution.col(columns.source + j).data();
            add_column(column, columns.target + j, rows, symmetric() ? j : 0);
        }
        if (symmetric()) rows = rows.subspan(1);
    }
}

void Front::add_column(const double* column, int target, std::span<const Placement::Run> rows, int above) {
    for (const Placement::Run& run : rows) {
        const double* from = column + run.source + above;
        double* to = entry(run.target + above, target);
        for (int i = 0; i < run.length - above; ++i) to[i] += from[i];
        above = 0;
    }
}

int Front::eliminate(double tolerance) {
    if (eliminated_ == 0) return -1;
    return symmetric() ? eliminate_symmetric(tolerance) : eliminate_general(tolerance);
}

int Front::eliminate_symmetric(double tolerance) {
    const int ordinary = eliminated_ - multipliers_;
    scale_ = panel_.topRows(eliminated_).diagonal();
    if (const int failed = lapack::cholesky(ordinary, panel_.data(), stride_); failed > 0) return failed - 1;
    for (int i = 0; i < ordinary; ++i) {
        if (vanishes(panel_(i, i) * panel_(i, i), scale_[i], tolerance)) return i;
    }
    lapack::solve_lower_transposed(multipliers_ + kept_, ordinary, panel_.data(), stride_, panel_.data() + ordinary,
                                   stride_);
    lapack::add_square(kept_, ordinary, -1.0, panel_.data() + eliminated_, stride_, 1.0, schur_.data(),
                       std::max(1, kept_));
    return multipliers_ > 0 ? eliminate_multipliers(tolerance) : -1;
}

// What the ordinary pivots leave of the multipliers' block is negative definite: its negative is factored.
int Front::eliminate_multipliers(double tolerance) {
    const int ordinary = eliminated_ - multipliers_;
    const auto columns = panel_.leftCols(ordinary).bottomRows(multipliers_ + kept_);
    auto own = panel_.rightCols(multipliers_).bottomRows(multipliers_ + kept_);
    own = columns * columns.topRows(multipliers_).transpose() - own;
    scale_.tail(multipliers_) = own.diagonal();
    double* pivots = own.data();
    if (const int failed = lapack::cholesky(multipliers_, pivots, stride_); failed > 0) return ordinary + failed - 1;
    for (int i = 0; i < multipliers_; ++i) {
        if (vanishes(own(i, i) * own(i, i), scale_[ordinary + i], tolerance)) return ordinary + i;
    }
    double* below = pivots + multipliers_;
    lapack::solve_triangle(Side::Right, Triangle::Lower, Op::Transposed, Diagonal::General, kept_, multipliers_, pivots,
                           stride_, below, stride_);
    lapack::add_square(kept_, multipliers_, 1.0, below, stride_, 1.0, schur_.data(), std::max(1, kept_));
    return -1;
}

void Front::measure_scales() {
    row_scale_.setZero(eliminated_);
    for (int column = 0; column < eliminated_; ++column) {
        const auto entries = panel_.col(column).head(eliminated_).cwiseAbs();
        scale_[column] = std::max(entries.maxCoeff(), std::numeric_limits<double>::min());
        row_scale_ = row_scale_.cwiseMax(entries / scale_[column]);
    }
}

int Front::eliminate_general(double tolerance) {
    pivots_.resize(size_of(eliminated_));
    measure_scales();
    if (const int failed = lapack::lu(eliminated_, panel_.data(), stride_, pivots_.data()); failed > 0) {
        return failed - 1;
    }
    lapack::interchange_rows(eliminated_, 1, row_scale_.data(), eliminated_, pivots_.data());
    for (int i = 0; i < eliminated_; ++i) {
        if (vanishes(std::abs(panel_(i, i)), scale_[i] * row_scale_[i], tolerance)) return i;
    }
    double* below = panel_.data() + eliminated_;
    lapack::solve_triangle(Side::Right, Triangle::Upper, Op::Plain, Diagonal::General, kept_, eliminated_,
                           panel_.data(), stride_, below, stride_);
    lapack::interchange_rows(eliminated_, kept_, upper_.data(), eliminated_, pivots_.data());
    lapack::solve_triangle(Side::Left, Triangle::Lower, Op::Plain, Diagonal::Unit, eliminated_, kept_, panel_.data(),
                           stride_, upper_.data(), eliminated_);
    lapack::subtract_product(kept_, kept_, eliminated_, below, stride_, upper_.data(), eliminated_, schur_.data(),
                             std::max(1, kept_));
    return -1;
}

void Front::minus_schur(const ConstVector& x, Vector product) const {
    if (symmetric())
        lapack::symmetric_product(kept_, -1.0, schur_.data(), std::max(1, kept_), x.data(), product.data());
    else
        product.noalias() = -schur_ * x;
}

void Front::mirror() {
    if (symmetric()) mirror_lower(schur_);
}

void Front::forward(Vector own, Vector kept) const {
    if (eliminated_ == 0) return;
    if (!symmetric()) lapack::interchange_rows(eliminated_, 1, own.data(), eliminated_, pivots_.data());
    lapack::solve_triangle(Triangle::Lower, Op::Plain, symmetric() ? Diagonal::General : Diagonal::Unit, eliminated_,
                           panel_.data(), stride_, own.data());
    lapack::subtract_product(Op::Plain, kept_, eliminated_, panel_.data() + eliminated_, stride_, own.data(),
                             kept.data());
    if (symmetric()) own.tail(multipliers_) *= -1.0;
}

void Front::backward(Vector own, const ConstVector& kept) const {
    if (eliminated_ == 0) return;
    if (symmetric()) {
        lapack::subtract_product(Op::Transposed, kept_, eliminated_, panel_.data() + eliminated_, stride_, kept.data(),
                                 own.data());
    } else {
        lapack::subtract_product(Op::Plain, eliminated_, kept_, upper_.data(), eliminated_, kept.data(), own.data());
    }
    lapack::solve_triangle(symmetric() ? Triangle::Lower : Triangle::Upper, symmetric() ? Op::Transposed : Op::Plain,
                           Diagonal::General, eliminated_, panel_.data(), stride_, own.data());
}

}  // namespace stria
