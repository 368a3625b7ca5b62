// SparseLeaf against dense algebra: a grid of springs, free or grounded, whole or in pieces.
#include "common/substructure/sparse_leaf.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

#include "common/error.hpp"
#include "tests/support/short_memory.hpp"

namespace stria {
namespace {

/// Springs between neighbours of an nx x ny grid of points, and to the ground at point 0. No springs cross from column
/// `gap` to the next.
SparseMatrix springs(int nx, int ny, double ground, int gap = -1) {
    std::vector<Triplet> entries;
    const auto spring = [&](int a, int b, double k) {
        entries.insert(entries.end(), {{a, a, k}, {b, b, k}, {a, b, -k}, {b, a, -k}});
    };
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const int point = j * nx + i;
            if (i + 1 < nx && i != gap) spring(point, point + 1, 1.0 + 0.1 * i + 0.03 * j);
            if (j + 1 < ny) spring(point, point + nx, 2.0 + 0.05 * i);
        }
    }
    if (ground > 0.0) entries.emplace_back(0, 0, ground);
    SparseMatrix matrix(nx * ny, nx * ny);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Eigen::MatrixXd dense_schur(const SparseMatrix& matrix, const std::vector<int>& b) {
    std::vector<int> i;
    for (int unknown = 0; unknown < matrix.rows(); ++unknown) {
        if (std::ranges::find(b, unknown) == b.end()) i.push_back(unknown);
    }
    const Eigen::MatrixXd k = matrix;
    const Eigen::MatrixXd inner = k(i, i), right = k(i, b);
    return k(b, b) - k(b, i) * inner.partialPivLu().solve(right);
}

std::vector<int> last_column(int nx, int ny) {
    std::vector<int> points;
    for (int j = ny; j-- > 0;) points.push_back(j * nx + nx - 1);
    return points;
}

double largest(const Eigen::MatrixXd& matrix) { return matrix.cwiseAbs().maxCoeff(); }

TEST(SparseLeaf, TangentIsTheDenseSchurComplement) {
    const SparseMatrix k = springs(14, 11, 3.0);
    const std::vector<int> boundary{40, 3, 77, 140, 41, 100};
    const SparseLeaf leaf(k, boundary);
    EXPECT_LT(largest(leaf.tangent() - dense_schur(k, boundary)), 1e-13);
    EXPECT_EQ(leaf.tangent(), leaf.tangent().transpose());
    EXPECT_GT(leaf.factor_entries(), static_cast<double>(k.rows()));
}

TEST(SparseLeaf, ReducedProblemGivesTheWholeSolution) {
    const SparseMatrix k = springs(14, 11, 3.0);
    const SparseLeaf leaf(k, last_column(14, 11));
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(k.rows(), -1.0, 2.0);
    const ReducedLoad reduced = leaf.reduce(load);
    const Eigen::VectorXd boundary = leaf.tangent().ldlt().solve(reduced.boundary);
    const Eigen::VectorXd x = leaf.expand(reduced, boundary);
    EXPECT_EQ(x(last_column(14, 11)), boundary);
    EXPECT_LT(largest(k * x - load), 1e-12);
}

TEST(SparseLeaf, AFloatingBodyHasASingularTangent) {
    const SparseMatrix k = springs(14, 11, 0.0);
    const SparseLeaf leaf(k, last_column(14, 11));
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(11);
    EXPECT_LT(largest(leaf.tangent() * ones), 1e-13);
    EXPECT_LT(largest(leaf.tangent() - dense_schur(k, last_column(14, 11))), 1e-13);
    const Eigen::VectorXd x = leaf.expand(leaf.reduce(Eigen::VectorXd::Zero(k.rows())), 0.5 * ones);
    EXPECT_LT(largest(x - Eigen::VectorXd::Constant(k.rows(), 0.5)), 1e-13);
}

TEST(SparseLeaf, ABoundaryOfSeveralPiecesStaysLastInItsOrder) {
    // Two bodies apart: the elimination tree would fall in two and its postorder put one boundary amid the other body.
    const SparseMatrix k = springs(12, 9, 0.0, 5);
    std::vector<int> boundary{11, 0, 6, 5, 53, 48};
    for (int turn = 0; turn < 6; ++turn) {
        const SparseLeaf leaf(k, boundary);
        EXPECT_LT(largest(leaf.tangent() - dense_schur(k, boundary)), 1e-13);
        std::ranges::rotate(boundary, boundary.begin() + 1);
    }
}

TEST(SparseLeaf, BoundaryMayBeEmpty) {
    const SparseMatrix k = springs(14, 11, 3.0);
    const SparseLeaf leaf(k, {});
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(k.rows(), 0.0, 1.0);
    EXPECT_EQ(leaf.tangent().size(), 0);
    EXPECT_LT(largest(k * leaf.expand(leaf.reduce(load), Eigen::VectorXd(0)) - load), 1e-11);
}

TEST(SparseLeaf, BoundaryMayBeEverything) {
    const SparseMatrix k = springs(6, 5, 0.0);
    std::vector<int> boundary(30);
    std::iota(boundary.rbegin(), boundary.rend(), 0);
    const SparseLeaf leaf(k, boundary);
    EXPECT_LT(largest(leaf.tangent() - Eigen::MatrixXd(k)(boundary, boundary)), 1e-14);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(30, 0.0, 1.0);
    EXPECT_LT(largest(leaf.reduce(load).boundary - load(boundary)), 1e-14);
    EXPECT_EQ(leaf.expand(leaf.reduce(load), load)(boundary), load);
}

TEST(SparseLeaf, AFloatingInteriorIsRefused) {
    EXPECT_THROW(SparseLeaf(springs(40, 40, 0.0), {}), NumericalFailure);
    EXPECT_THROW(SparseLeaf(springs(12, 9, 0.0, 5), last_column(12, 9)), NumericalFailure);
}

TEST(SparseLeaf, AnIndefiniteInteriorIsRefused) {
    SparseMatrix k = springs(6, 5, 1.0);
    k.coeffRef(12, 12) = -1.0;
    EXPECT_THROW(SparseLeaf(k, {0}), NumericalFailure);
    EXPECT_NO_THROW(SparseLeaf(springs(6, 5, 1.0), {12}));
}

// No matter at which place it runs out: the matrix is as good as before.
TEST(SparseLeaf, ShortMemoryIsNoFlawOfTheMatrix) {
    const SparseMatrix k = springs(14, 11, 3.0);
    EXPECT_GT(test::allocations_of([&] { const SparseLeaf leaf(k, last_column(14, 11)); }), 10);
    const SparseLeaf leaf(k, last_column(14, 11));
    EXPECT_GT(test::allocations_of([&] { (void)leaf.reduce(Eigen::VectorXd::Ones(k.rows())); }), 0);
}

TEST(SparseLeaf, AWrongBoundaryIsAMistake) {
    EXPECT_THROW(SparseLeaf(springs(3, 3, 1.0), {9}), std::logic_error);
    EXPECT_THROW(SparseLeaf(springs(3, 3, 1.0), {1, 1}), std::logic_error);
}

}  // namespace
}  // namespace stria
