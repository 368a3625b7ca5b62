#include "common/linear/sparse_leaf.hpp"

#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "common/error.hpp"
#include "common/linear/lapack.hpp"
#include "common/linear/sparse_lu.hpp"

namespace stria {
namespace {

constexpr int largest_for_amd = 20000;  // unknowns; above, METIS costs ten times as much to order but fills in less

auto at(int i) { return static_cast<std::size_t>(i); }

/// CHOLMOD's view of a symmetric matrix of which the lower triangle is stored.
cholmod_sparse view(SparseMatrix& lower) {
    cholmod_sparse result{};
    result.nrow = result.ncol = static_cast<std::size_t>(lower.rows());
    result.nzmax = static_cast<std::size_t>(lower.nonZeros());
    result.p = lower.outerIndexPtr();
    result.i = lower.innerIndexPtr();
    result.x = lower.valuePtr();
    result.stype = -1;
    result.itype = CHOLMOD_INT;
    result.xtype = CHOLMOD_REAL;
    result.dtype = CHOLMOD_DOUBLE;
    result.sorted = result.packed = 1;
    return result;
}

/// Lower triangle of K_ii. The interior keeps its order, so that the rows of a column stay sorted.
SparseMatrix interior_block(const SparseMatrix& stiffness, const std::vector<int>& interior) {
    std::vector<int> number(at(static_cast<int>(stiffness.rows())), -1);
    for (int i = 0; i < static_cast<int>(interior.size()); ++i) number[at(interior[at(i)])] = i;
    SparseMatrix block(std::ssize(interior), std::ssize(interior));
    block.reserve(stiffness.nonZeros() / 2 + stiffness.rows());
    for (int column = 0; column < block.outerSize(); ++column) {
        block.startVec(column);
        for (SparseMatrix::InnerIterator entry(stiffness, interior[at(column)]); entry; ++entry) {
            const int row = number[at(entry.index())];
            if (row >= column) block.insertBack(row, column) = entry.value();
        }
    }
    block.finalize();
    return block;
}

/// The last unknown in elimination order of each connected piece of the interior.
std::vector<int> last_of_pieces(const SparseMatrix& stiffness, std::span<const int> order, int interior) {
    std::vector<bool> reached(at(static_cast<int>(stiffness.rows())));
    for (const int unknown : order.subspan(at(interior))) reached[at(unknown)] = true;
    std::vector<int> last, pending;
    for (int place = interior - 1; place >= 0; --place) {
        if (reached[at(order[at(place)])]) continue;
        last.push_back(order[at(place)]);
        reached[at(last.back())] = true;
        pending.assign(1, last.back());
        while (!pending.empty()) {
            const int unknown = pending.back();
            pending.pop_back();
            for (SparseMatrix::InnerIterator entry(stiffness, unknown); entry; ++entry) {
                if (reached[at(entry.index())]) continue;
                reached[at(entry.index())] = true;
                pending.push_back(entry.index());
            }
        }
    }
    return last;
}

/// tau on the boundary's diagonal, and explicit zeros that make the top of the elimination tree one path along the
/// boundary with every piece of the interior below it: no postordering can then move the boundary from its place.
SparseMatrix boundary_ties(const SparseMatrix& stiffness, std::span<const int> order, int interior, double tau) {
    const auto boundary = order.subspan(at(interior));
    std::vector<Triplet> ties;
    const auto tie = [&](int a, int b, double value) { ties.emplace_back(std::max(a, b), std::min(a, b), value); };
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        tie(boundary[i], boundary[i], tau);
        if (i > 0) tie(boundary[i - 1], boundary[i], 0.0);
    }
    if (!boundary.empty()) {
        for (const int unknown : last_of_pieces(stiffness, order, interior)) tie(unknown, boundary.front(), 0.0);
    }
    SparseMatrix result(stiffness.rows(), stiffness.cols());
    result.setFromTriplets(ties.begin(), ties.end());
    return result;
}

}  // namespace

struct SparseLeaf::Factor {
    Factor() {
        cholmod_start(&common);
        common.print = 0;
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_GIVEN;
    }
    Factor(const Factor&) = delete;
    Factor& operator=(const Factor&) = delete;
    ~Factor() {
        cholmod_free_factor(&cholesky, &common);
        cholmod_finish(&common);
    }

    [[nodiscard]] int size() const { return static_cast<int>(order.size()); }
    [[nodiscard]] int boundary() const { return size() - interior; }

    void choose_order(const SparseMatrix& stiffness, const std::vector<int>& boundary);
    void factor(const SparseMatrix& stiffness);
    void read_supernodes(const Eigen::VectorXd& diagonal);
    void check_pivot(int place, double pivot, double diagonal) const;
    Eigen::VectorXd solve(int system, Eigen::VectorXd right_hand_side);

    cholmod_common common{};
    cholmod_factor* cholesky = nullptr;
    std::vector<int> order;  // unknowns in elimination order: the interior, then the boundary as given
    int interior = 0;
    double tau = 0.0;  // added to the boundary's diagonal, so that a floating body has a factor
    double entries = 0.0;
    Eigen::MatrixXd last;  // L22: L L^T of K + tau I_b, boundary rows and columns; zeros above
};

void SparseLeaf::Factor::choose_order(const SparseMatrix& stiffness, const std::vector<int>& boundary) {
    std::vector<bool> kept(at(static_cast<int>(stiffness.rows())));
    for (const int unknown : boundary) {
        require(unknown >= 0 && unknown < stiffness.rows(), "sparse leaf: boundary unknown out of range");
        require(!kept[at(unknown)], "sparse leaf: a boundary unknown named twice");
        kept[at(unknown)] = true;
    }
    std::vector<int> inside;
    for (int unknown = 0; unknown < stiffness.rows(); ++unknown) {
        if (!kept[at(unknown)]) inside.push_back(unknown);
    }
    interior = static_cast<int>(inside.size());
    std::vector<int> permutation(inside.size());
    if (interior > 0) {
        SparseMatrix block = interior_block(stiffness, inside);
        cholmod_sparse pattern = view(block);
        const bool ordered = interior < largest_for_amd
                                 ? cholmod_amd(&pattern, nullptr, 0, permutation.data(), &common) != 0
                                 : cholmod_metis(&pattern, nullptr, 0, 1, permutation.data(), &common) != 0;
        if (!ordered) throw NumericalFailure("sparse leaf: CHOLMOD found no ordering");
    }
    order.clear();
    for (const int place : permutation) order.push_back(inside[at(place)]);
    order.insert(order.end(), boundary.begin(), boundary.end());
}

void SparseLeaf::Factor::factor(const SparseMatrix& stiffness) {
    const Eigen::VectorXd diagonal = stiffness.diagonal();
    tau = boundary() > 0 ? diagonal.mean() : 0.0;
    SparseMatrix lower = stiffness.triangularView<Eigen::Lower>();
    lower += boundary_ties(stiffness, order, interior, tau);
    lower.makeCompressed();
    cholmod_sparse matrix = view(lower);
    cholesky = cholmod_analyze_p(&matrix, order.data(), nullptr, 0, &common);
    if (cholesky == nullptr) throw NumericalFailure("sparse leaf: CHOLMOD could not analyse the matrix");
    const bool done = cholmod_factorize(&matrix, cholesky, &common) != 0;
    const std::span final_order(static_cast<const int*>(cholesky->Perm), cholesky->n);
    require(std::equal(order.begin() + interior, order.end(), final_order.begin() + interior),
            "sparse leaf: the boundary left its place");
    order.assign(final_order.begin(), final_order.end());
    if (!done || common.status != CHOLMOD_OK) {
        const bool known = cholesky->minor < cholesky->n;
        const std::string where = known ? " at unknown " + std::to_string(order[cholesky->minor]) : "";
        throw NumericalFailure("the stiffness of the structure is not positive definite" + where);
    }
    read_supernodes(diagonal);
}

void SparseLeaf::Factor::read_supernodes(const Eigen::VectorXd& diagonal) {
    const auto* super = static_cast<const int*>(cholesky->super);
    const auto* first_row = static_cast<const int*>(cholesky->pi);
    const auto* first_value = static_cast<const int*>(cholesky->px);
    const auto* rows = static_cast<const int*>(cholesky->s);
    const auto* values = static_cast<const double*>(cholesky->x);
    last.setZero(boundary(), boundary());
    for (std::size_t node = 0; node < cholesky->nsuper; ++node) {
        const int height = first_row[node + 1] - first_row[node];
        for (int j = 0; j < super[node + 1] - super[node]; ++j) {
            const int column = super[node] + j;
            const double* value = values + first_value[node] + static_cast<std::ptrdiff_t>(j) * height;
            entries += height - j;
            if (column < interior) {
                check_pivot(column, value[j] * value[j], diagonal[order[at(column)]]);
                continue;
            }
            for (int i = j; i < height; ++i) {
                last(rows[first_row[node] + i] - interior, column - interior) = value[i];
            }
        }
    }
}

void SparseLeaf::Factor::check_pivot(int place, double pivot, double diagonal) const {
    // Measured on floating grids of 242 to 181 000 unknowns: rounding leaves n eps / 4 of the diagonal entry; a clamped
    // strip, 1000 times as long as thick, leaves 1e-10.
    const double vanishing = interior * std::numeric_limits<double>::epsilon();
    if (pivot > vanishing * diagonal && std::isfinite(pivot)) return;
    throw NumericalFailure("the stiffness of the structure is singular at unknown " + std::to_string(order[at(place)]));
}

Eigen::VectorXd SparseLeaf::Factor::solve(int system, Eigen::VectorXd right_hand_side) {
    cholmod_dense b{};
    b.nrow = b.nzmax = b.d = static_cast<std::size_t>(right_hand_side.size());
    b.ncol = 1;
    b.x = right_hand_side.data();
    b.xtype = CHOLMOD_REAL;
    b.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_solve(system, cholesky, &b, &common);
    if (x == nullptr) throw NumericalFailure("sparse leaf: CHOLMOD could not solve");
    std::copy_n(static_cast<const double*>(x->x), right_hand_side.size(), right_hand_side.data());
    cholmod_free_dense(&x, &common);
    return right_hand_side;
}

SparseLeaf::SparseLeaf(const SparseMatrix& stiffness, std::vector<int> boundary) : factor_(std::make_unique<Factor>()) {
    require(stiffness.rows() == stiffness.cols() && stiffness.rows() > 0, "sparse leaf: a square matrix");
    use_one_thread();  // OpenMP keeps this setting per thread of ours, and an in-process component is one
    factor_->choose_order(stiffness, boundary);
    factor_->factor(stiffness);
    const int m = factor_->boundary();
    const int stride = std::max(1, m);
    tangent_.setZero(m, m);
    lapack::add_square(m, m, 1.0, factor_->last.data(), stride, 0.0, tangent_.data(), stride);
    tangent_.diagonal().array() -= factor_->tau;
    tangent_ = tangent_.selfadjointView<Eigen::Lower>();
}

SparseLeaf::~SparseLeaf() = default;

const Eigen::MatrixXd& SparseLeaf::tangent() const { return tangent_; }

ReducedLoad SparseLeaf::reduce(const Eigen::VectorXd& load) const {
    require(load.size() == factor_->size(), "sparse leaf: a load on all unknowns");
    const Eigen::VectorXd y = factor_->solve(CHOLMOD_L, load(factor_->order));
    // b_b - L21 y1 = L22 y2: tau has gone from what is carried over.
    const Eigen::VectorXd carried = factor_->last * y.tail(factor_->boundary());
    return {.interior = y.head(factor_->interior), .boundary = carried};
}

Eigen::VectorXd SparseLeaf::expand(const ReducedLoad& load, const Eigen::VectorXd& boundary) const {
    require(load.interior.size() == factor_->interior && boundary.size() == factor_->boundary(),
            "sparse leaf: expand() wants what reduce() gave");
    Eigen::VectorXd y(factor_->size());
    y.head(factor_->interior) = load.interior;
    y.tail(factor_->boundary()).noalias() = factor_->last.transpose() * boundary;
    Eigen::VectorXd x(factor_->size());
    x(factor_->order) = factor_->solve(CHOLMOD_Lt, std::move(y));
    for (int i = 0; i < factor_->boundary(); ++i) x[factor_->order[at(factor_->interior + i)]] = boundary[i];
    return x;
}

double SparseLeaf::factor_entries() const { return factor_->entries; }

}  // namespace stria
