#include "common/substructure/sparse_leaf.hpp"

#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>
#include <string>
#include <utility>

#include "common/error.hpp"
#include "common/index.hpp"
#include "common/linear/blas.hpp"
#include "common/linear/lapack.hpp"
#include "common/linear/lower_block.hpp"

namespace stria {
namespace {

/// CHOLMOD's view of a symmetric matrix of which the lower triangle is stored.
cholmod_sparse view(SparseMatrix& lower) {
    cholmod_sparse result{};
    result.nrow = result.ncol = at(lower.rows());
    result.nzmax = at(lower.nonZeros());
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

}  // namespace

struct SparseLeaf::Factor {
    Factor() {
        cholmod_start(&common);
        common.print = 0;
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_NATURAL;
        common.postorder = 0;  // the boundary must not leave its place; the orders we give are postorders
    }
    Factor(const Factor&) = delete;
    Factor& operator=(const Factor&) = delete;
    ~Factor() {
        cholmod_free_factor(&cholesky, &common);
        cholmod_finish(&common);
    }

    [[nodiscard]] int size() const { return static_cast<int>(order.size()); }
    [[nodiscard]] int boundary() const { return size() - interior; }

    void expect(bool done, const char* otherwise) const;
    void choose_order(const SparseMatrix& stiffness, const std::vector<int>& boundary);
    void factor(SparseMatrix& lower);
    void read_supernodes(const Eigen::VectorXd& diagonal);
    void check_pivot(int place, double pivot, double diagonal) const;
    Eigen::VectorXd solve(int system, Eigen::VectorXd right_hand_side);
    void solve_last(Eigen::VectorXd& x) const;

    cholmod_common common{};
    cholmod_factor* cholesky = nullptr;
    std::vector<int> order;  // unknowns in elimination order: the interior, then the boundary as given
    int interior = 0;
    double tau = 0.0;  // added to the boundary's diagonal, so that a floating body has a factor
    double entries = 0.0;
    Eigen::MatrixXd last;  // L22: L L^T of K + tau I_b, boundary rows and columns; zeros above
};

// Short of memory, or of integers to count the factor, the matrix is none the worse: as where any allocation fails.
void SparseLeaf::Factor::expect(bool done, const char* otherwise) const {
    if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
    if (!done) throw NumericalFailure(otherwise);
}

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
        SparseMatrix block = lower_block(stiffness, inside);
        cholmod_sparse pattern = view(block);
        const bool ordered = cholmod_amd(&pattern, nullptr, 0, permutation.data(), &common) != 0;
        expect(ordered, "sparse leaf: CHOLMOD found no ordering");
    }
    order.clear();
    for (const int place : permutation) order.push_back(inside[at(place)]);
    order.insert(order.end(), boundary.begin(), boundary.end());
}

// `lower`: rows and columns in the order of elimination; tau is added in place.
void SparseLeaf::Factor::factor(SparseMatrix& lower) {
    const Eigen::VectorXd diagonal = lower.diagonal();
    tau = boundary() > 0 ? diagonal.mean() : 0.0;
    if (boundary() == size() && tau == 0.0) tau = 1.0;  // no stiffness at all: the zone is the whole body
    for (int i = interior; i < size(); ++i) lower.coeffRef(i, i) += tau;
    lower.makeCompressed();  // boundary unknowns that no element here sees had no diagonal
    cholmod_sparse matrix = view(lower);
    cholesky = cholmod_analyze(&matrix, &common);
    expect(cholesky != nullptr, "sparse leaf: CHOLMOD could not analyse the matrix");
    const bool done = cholmod_factorize(&matrix, cholesky, &common) != 0;
    expect(done, "sparse leaf: CHOLMOD could not factor the matrix");
    if (common.status != CHOLMOD_OK) {
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
                check_pivot(column, value[j] * value[j], diagonal[column]);
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
    b.nrow = b.nzmax = b.d = at(right_hand_side.size());
    b.ncol = 1;
    b.x = right_hand_side.data();
    b.xtype = CHOLMOD_REAL;
    b.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_solve(system, cholesky, &b, &common);
    expect(x != nullptr, "sparse leaf: CHOLMOD could not solve");
    std::copy_n(static_cast<const double*>(x->x), right_hand_side.size(), right_hand_side.data());
    cholmod_free_dense(&x, &common);
    return right_hand_side;
}

// L^T x = y for the last unknowns alone, in place: none of the others has a share in them. Supernode by supernode from
// the end; of the one in which they begin, its last columns.
void SparseLeaf::Factor::solve_last(Eigen::VectorXd& x) const {
    const auto* super = static_cast<const int*>(cholesky->super);
    const auto* first_row = static_cast<const int*>(cholesky->pi);
    const auto* first_value = static_cast<const int*>(cholesky->px);
    const auto* rows = static_cast<const int*>(cholesky->s);
    const auto* values = static_cast<const double*>(cholesky->x);
    const int first = size() - static_cast<int>(x.size());
    Eigen::VectorXd below;
    for (std::size_t node = cholesky->nsuper; node-- > 0 && super[node + 1] > first;) {
        const int skipped = std::max(0, first - super[node]);
        const int height = first_row[node + 1] - first_row[node];
        const int columns = super[node + 1] - super[node] - skipped, lower = height - skipped - columns;
        const double* block = values + first_value[node] + static_cast<std::ptrdiff_t>(skipped) * (height + 1);
        const int* below_rows = rows + first_row[node] + skipped + columns;
        below.resize(lower);
        for (int i = 0; i < lower; ++i) below[i] = x[below_rows[i] - first];
        double* own = x.data() + super[node] + skipped - first;
        if (lower > 0)
            lapack::subtract_product(lapack::Op::Transposed, lower, columns, block + columns, height, below.data(),
                                     own);
        lapack::solve_triangle(lapack::Triangle::Lower, lapack::Op::Transposed, lapack::Diagonal::General, columns,
                               block, height, own);
    }
}

SparseLeaf::SparseLeaf(const SparseMatrix& stiffness, const std::vector<int>& boundary)
    : factor_(std::make_unique<Factor>()) {
    require(stiffness.rows() == stiffness.cols() && stiffness.rows() > 0, "sparse leaf: a square matrix");
    factor_->choose_order(stiffness, boundary);
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> place(stiffness.rows());
    for (int i = 0; i < factor_->size(); ++i) place.indices()[factor_->order[at(i)]] = i;
    SparseMatrix upper(stiffness.rows(), stiffness.cols());
    upper.selfadjointView<Eigen::Upper>() = stiffness.selfadjointView<Eigen::Lower>().twistedBy(place);
    SparseMatrix lower = SparseMatrix(upper.transpose());  // sorts the rows of each column
    condense(lower);
}

SparseLeaf::SparseLeaf(int boundary, SparseMatrix&& lower, Answers answers)
    : factor_(std::make_unique<Factor>()), kind_(answers) {
    require(lower.rows() == lower.cols() && lower.rows() > 0, "sparse leaf: a square matrix");
    require(boundary >= 0 && boundary <= lower.rows(), "sparse leaf: no more boundary unknowns than unknowns");
    factor_->order.resize(at(static_cast<int>(lower.rows())));
    std::iota(factor_->order.begin(), factor_->order.end(), 0);
    factor_->interior = factor_->size() - boundary;
    condense(lower);
}

void SparseLeaf::condense(SparseMatrix& lower) {
    use_one_thread();  // OpenMP keeps this setting per thread of ours, and an in-process component is one
    factor_->factor(lower);
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
    if (kind_ == Answers::Anew) return reduce_anew(load);
    constexpr std::size_t most = 6;  // a structure has no more of them
    const auto known = std::ranges::find_if(answers_, [&](const Answer& answer) { return answer.load == load; });
    if (known != answers_.end()) return known->reduced;
    if (answers_.size() == most) answers_.erase(answers_.begin());
    answers_.push_back({load, reduce_anew(load)});
    return answers_.back().reduced;
}

// An answer that is known is copied to its place and nowhere else.
Eigen::VectorXd SparseLeaf::reduce_interior(const ConstPart& load, Part reduced) const {
    const auto known = std::ranges::find_if(answers_, [&](const Answer& answer) {
        return answer.load.head(load.size()) == load && answer.load.tail(factor_->boundary()).isZero(0.0);
    });
    if (known == answers_.end()) return Substructure::reduce_interior(load, reduced);
    reduced = known->reduced.interior;
    return known->reduced.boundary;
}

ReducedLoad SparseLeaf::reduce_anew(const Eigen::VectorXd& load) const {
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

Eigen::VectorXd SparseLeaf::expand_last(const Eigen::VectorXd& last_of_load, const Eigen::VectorXd& boundary) const {
    const int kept = factor_->boundary();
    require(boundary.size() == kept && last_of_load.size() <= factor_->interior,
            "sparse leaf: expand_last() wants the end of what reduce() gave");
    Eigen::VectorXd x(last_of_load.size() + kept);
    x.head(last_of_load.size()) = last_of_load;
    x.tail(kept).noalias() = factor_->last.transpose() * boundary;
    factor_->solve_last(x);
    x.tail(kept) = boundary;
    return x;
}

int SparseLeaf::unknowns() const { return factor_->size(); }

double SparseLeaf::factor_entries() const { return factor_->entries; }

}  // namespace stria
