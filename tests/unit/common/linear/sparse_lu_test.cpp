// SparseLu against dense LU, on matrices shaped like those of the monolithic method.
#include "common/linear/sparse_lu.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "common/error.hpp"
#include "tests/support/short_memory.hpp"

namespace stria {
namespace {

/// Displacements along a chain of springs, and pressures whose rows hold every third of them. `friction`: what makes
/// the column of a pressure differ from its row.
SparseMatrix held_chain(int springs, double stiffness, double length, double friction) {
    std::vector<Triplet> entries;
    int next = springs;
    for (int i = 0; i < springs; ++i) {
        entries.emplace_back(i, i, 2.0 * stiffness);
        if (i + 1 < springs) {
            entries.emplace_back(i, i + 1, -stiffness);
            entries.emplace_back(i + 1, i, -stiffness);
        }
        if (i % 3 != 0) continue;
        entries.emplace_back(next, i, length);
        entries.emplace_back(i, next, length);
        if (i > 0) entries.emplace_back(i - 1, next, friction * length);
        ++next;
    }
    SparseMatrix matrix(next, next);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

TEST(SparseLu, AgreesWithDenseAlgebra) {
    const SparseMatrix a = held_chain(40, 1.0, 1.0, 0.3);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(a.rows(), -1.0, 1.0);
    const Eigen::VectorXd expected = Eigen::MatrixXd(a).partialPivLu().solve(b);
    EXPECT_LT((SparseLu(a).solve(b) - expected).cwiseAbs().maxCoeff(), 1e-13 * expected.cwiseAbs().maxCoeff());
}

TEST(SparseLu, ServesManyRightHandSides) {
    SparseMatrix a = held_chain(40, 1.0, 1.0, 0.3);
    const Eigen::MatrixXd dense = a;
    const SparseLu factor(a);
    a.setZero();  // the factor holds what it needs
    for (const double last : {1.0, -3.0}) {
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(a.rows(), -1.0, last);
        const Eigen::VectorXd expected = dense.partialPivLu().solve(b);
        EXPECT_LT((factor.solve(b) - expected).cwiseAbs().maxCoeff(), 1e-13 * expected.cwiseAbs().maxCoeff());
    }
}

TEST(SparseLu, ShortMemoryIsNoFlawOfTheMatrix) {
    const SparseMatrix a = held_chain(40, 1.0, 1.0, 0.3);
    EXPECT_GT(test::allocations_of([&] { const SparseLu factor(a); }), 10);
    const SparseLu factor(a);
    EXPECT_GT(test::allocations_of([&] { (void)factor.solve(Eigen::VectorXd::Ones(a.rows())); }), 0);
}

TEST(SparseLu, BearsTheUnitsOfContact) {
    // MPa beside 1e-5 mm: badly scaled, not singular. Each row is judged by the size of its own terms.
    const SparseMatrix a = held_chain(60, 2e5, 1e-5, 0.1);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(a.rows(), 1.0, 2.0);
    const Eigen::VectorXd x = SparseLu(a).solve(b);
    const Eigen::VectorXd terms = a.cwiseAbs() * x.cwiseAbs() + b.cwiseAbs();
    EXPECT_LT(((a * x - b).array() / terms.array()).abs().maxCoeff(), 1e-14);
}

TEST(SparseLu, RefusesASingularMatrix) {
    SparseMatrix exactly = held_chain(10, 1.0, 0.0, 0.0);  // empty rows
    EXPECT_THROW(SparseLu{exactly}, NumericalFailure);
    std::vector<Triplet> ring;  // floats: singular to rounding only
    for (int i = 0; i < 50; ++i) {
        const double k = 1.0 / (i + 3.0);
        const int j = (i + 1) % 50;
        ring.insert(ring.end(), {{i, i, k}, {j, j, k}, {i, j, -k}, {j, i, -k}});
    }
    SparseMatrix nearly(50, 50);
    nearly.setFromTriplets(ring.begin(), ring.end());
    EXPECT_THROW(SparseLu{nearly}, NumericalFailure);
}

TEST(SparseLu, RefusesWhatIsNotANumber) {
    SparseMatrix a = held_chain(10, 1.0, 1.0, 0.1);
    a.coeffRef(4, 4) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(SparseLu{a}, NumericalFailure);
}

}  // namespace
}  // namespace stria
