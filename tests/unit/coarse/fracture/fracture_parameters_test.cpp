// K of several loads together.
#include "coarse/fracture/fracture_parameters.hpp"

#include <gtest/gtest.h>

namespace stria::coarse {
namespace {

TipResult nominal() {
    TipResult tip;
    tip.K_I = 5.1;
    tip.K_II = 0.7;
    tip.K_I_of_cases = {1.7, -0.3};
    tip.K_II_of_cases = {0.0, 2.0};
    tip.K_initial = 40.0;
    tip.K_II_initial = -1.0;
    return tip;
}

TEST(KUnderLoads, IsTheSumOfWhatEachHas) {
    const LoadFactors loads{10.0, Eigen::Vector2d(2.0, 30.0)};
    EXPECT_DOUBLE_EQ(K_I_under(nominal(), loads), 51.0 + 3.4 - 9.0 + 40.0);
    EXPECT_DOUBLE_EQ(K_II_under(nominal(), loads), 7.0 + 60.0 - 1.0);
    EXPECT_DOUBLE_EQ(K_I_under(nominal(), 10.0), 91.0) << "factors that nobody gives are zero";
}

TEST(KUnderLoads, IsZeroWhereLoadsCancelButForRounding) {
    TipResult tip = nominal();
    tip.K_initial = 0.0;
    tip.K_I_of_cases = {tip.K_I * (1.0 + 1e-12)};
    const auto of_two = [&](double second) { return K_I_under(tip, {60.0, Eigen::VectorXd::Constant(1, second)}); };
    EXPECT_EQ(of_two(-60.0), 0.0);
    EXPECT_NEAR(of_two(-60.0 + 1e-5), 5.1e-5, 1e-8);
    EXPECT_EQ(K_I_under(tip, 1e-30), 5.1e-30) << "a small load is one";
}

TEST(FactorsOfCases, GoStraightFromOneMomentToAnother) {
    const Eigen::VectorXd found = between(Eigen::VectorXd::Constant(1, 4.0), Eigen::Vector2d(8.0, 1.0), 0.25);
    EXPECT_EQ(found, Eigen::Vector2d(5.0, 0.25));
    EXPECT_EQ(between({}, {}, 0.5).size(), 0);
}

}  // namespace
}  // namespace stria::coarse
