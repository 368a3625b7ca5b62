// Symmetric matrices of which nothing can be read above the diagonal.
#include "common/linear/lower_triangle.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/plates.hpp"

namespace stria {
namespace {

Eigen::MatrixXd symmetric(int n) {
    const Eigen::MatrixXd A = test::random_vector(n * n, 1.0, 3).reshaped(n, n);
    return A + A.transpose();
}

Eigen::MatrixXd lower_of(Eigen::MatrixXd A) {
    A.triangularView<Eigen::StrictlyUpper>().setConstant(std::numeric_limits<double>::quiet_NaN());
    return A;
}

TEST(LowerTriangle, TellsTheWhole) {
    for (const int n : {0, 1, 5, 70}) {  // 70: more than one tile
        const Eigen::MatrixXd A = symmetric(n);
        Eigen::MatrixXd lower = lower_of(A);
        const Eigen::VectorXd x = test::random_vector(n, 1.0, 4);
        EXPECT_LE((times_lower(lower, x) - A * x).norm(), 1e-13 * (1.0 + A.norm() * x.norm())) << n;
        mirror_lower(lower);
        EXPECT_EQ(lower, A) << n;
    }
}

}  // namespace
}  // namespace stria
