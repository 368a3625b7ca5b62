// Roots between two places, by few values of the function.
#include "common/regula_falsi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace stria::test {
namespace {

double guess_after(int values, const std::function<double(double)>& of) {
    RegulaFalsi root;
    for (int k = 0; k < values; ++k) root.narrow(of(root.guess()));
    return root.guess();
}

TEST(RegulaFalsi, FindsTheRootOfAStraightLineAtOnce) {
    EXPECT_NEAR(guess_after(1, [](double x) { return 1.0 - 5.0 * x; }), 0.2, 1e-15);
}

// An end that counted in full for ever would leave 0.29 of the way.
TEST(RegulaFalsi, DoesNotCreepWhereTheFunctionIsBent) {
    EXPECT_NEAR(guess_after(12, [](double x) { return 1.0 - 50.0 * std::pow(x, 6.0); }), std::pow(50.0, -1.0 / 6.0),
                1e-3);
}

TEST(RegulaFalsi, KnowsWhetherARootHasBeenPassed) {
    RegulaFalsi root;
    EXPECT_FALSE(root.has_passed());
    root.narrow(-1.0);
    EXPECT_TRUE(root.has_passed());
    root.narrow(0.5);
    EXPECT_TRUE(root.has_passed());
}

}  // namespace
}  // namespace stria::test
