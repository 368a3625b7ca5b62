// Half steps where Newton's method goes to and fro.
#include "coarse/equilibrium/damping.hpp"

#include <gtest/gtest.h>

namespace stria::coarse {
namespace {

std::vector<double> factors(const std::vector<double>& residuals) {
    Damping damping;
    std::vector<double> found;
    for (const double residual : residuals) found.push_back(damping.factor(residual));
    return found;
}

TEST(Damping, LeavesStepsThatLeadSomewhere) {
    for (const double factor : factors({8.0, 9.0, 4.0, 3.0, 1.0, 0.5, 0.1, 0.01, 1e-5})) EXPECT_EQ(factor, 1.0);
}

TEST(Damping, TakesPartsOfThoseBetweenTwoStates) {
    EXPECT_EQ(factors({8.0, 2.0, 1.0, 1.1, 1.0, 1.1, 1.0, 1.1, 1.0, 1.1, 0.4}),
              (std::vector<double>{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.5, 0.5, 0.25, 0.75, 1.0}));
}

}  // namespace
}  // namespace stria::coarse
