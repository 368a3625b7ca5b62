// The linear system of a Newton step against LU of the whole of it.
#include "coarse/equilibrium/condensed/bordered_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

#include "tests/support/plates.hpp"

namespace stria::coarse {
namespace {

constexpr int n = 7;

Eigen::MatrixXd random_matrix() { return test::random_vector(n * n, 1.0, 5).reshaped(n, n); }

/// `shift`: added to the diagonal of a symmetric one.
Eigen::MatrixXd symmetric(double shift) {
    const Eigen::MatrixXd A = random_matrix();
    return A + A.transpose() + shift * Eigen::MatrixXd::Identity(n, n);
}

/// As a zone tells it: nothing can be read above the diagonal of a symmetric one.
CondensedTangent told(Eigen::MatrixXd A, Symmetry symmetry) {
    if (symmetry == Symmetry::Symmetric)
        A.triangularView<Eigen::StrictlyUpper>().setConstant(std::numeric_limits<double>::quiet_NaN());
    return {std::move(A), symmetry};
}

LinearReading a_displacement() { return {test::random_vector(n, 1.0, 6), 0.3, 0.0}; }

void expect_solved(const Eigen::MatrixXd& A, Symmetry symmetry, const LinearReading& controlled) {
    const Eigen::VectorXd residual = test::random_vector(n, 1.0, 7), derivative = test::random_vector(n, 1.0, 8);
    constexpr double off_target = 0.7;
    BorderedSystem system;
    system.factor([&] { return told(A, symmetry); }, controlled);
    const GammaState found = system.solve(residual, off_target, derivative, controlled);

    Eigen::MatrixXd whole(n + 1, n + 1);
    whole << A, -derivative, controlled.weights.transpose(), controlled.per_load_factor;
    Eigen::VectorXd right(n + 1);
    right << residual, off_target;
    const Eigen::VectorXd expected = whole.partialPivLu().solve(right);
    EXPECT_LT((found.displacement - expected.head(n)).norm(), 1e-11 * expected.norm());
    EXPECT_NEAR(found.load_factor, expected[n], 1e-11 * expected.norm());
}

TEST(BorderedSystem, SolvesWithHalfOfADefiniteTangent) {
    expect_solved(symmetric(10.0), Symmetry::Symmetric, LinearReading::load_factor(n));
    expect_solved(symmetric(10.0), Symmetry::Symmetric, a_displacement());
}

TEST(BorderedSystem, SolvesWithHalfOfAnIndefiniteTangent) {
    expect_solved(symmetric(0.0), Symmetry::Symmetric, LinearReading::load_factor(n));
    expect_solved(symmetric(0.0), Symmetry::Symmetric, a_displacement());
}

TEST(BorderedSystem, SolvesWithAGeneralTangent) {
    expect_solved(random_matrix(), Symmetry::General, LinearReading::load_factor(n));
    expect_solved(random_matrix(), Symmetry::General, a_displacement());
}

TEST(CondensedTangent, HasWholeColumns) {
    const Eigen::MatrixXd A = symmetric(0.0), B = random_matrix();
    for (int j = 0; j < n; ++j) {
        EXPECT_EQ(told(A, Symmetry::Symmetric).column(j), A.col(j));
        EXPECT_EQ(told(B, Symmetry::General).column(j), B.col(j));
    }
}

}  // namespace
}  // namespace stria::coarse
