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

// One matrix and two components named one tip and the other: what they round told them apart.
TEST(DeepestOverlap, IsTheFirstOfTwoThatRoundingTellsApart) {
    const std::vector<CrackSection> cracks(1);
    std::vector<coupling::FaceSample> faces(4);
    for (std::size_t k = 0; k < faces.size(); ++k) faces[k].s = static_cast<double>(k);
    faces[0].opening = 0.01;
    faces[1].opening = -0.001;
    faces[2].opening = -0.0005;
    for (const double rounding : {1e-12, 0.0, -1e-12}) {
        faces[3].opening = (1.0 + rounding) * faces[1].opening;
        EXPECT_EQ(deepest_overlap(faces, cracks), &faces[1]) << rounding;
    }
    faces[3].opening = 1.001 * faces[1].opening;
    EXPECT_EQ(deepest_overlap(faces, cracks), &faces[3]);
    faces[1].opening = faces[3].opening = 0.0;
    faces[2].opening = -1e-6;  // of a jump of 0.01
    EXPECT_EQ(deepest_overlap(faces, cracks), nullptr);
}

}  // namespace
}  // namespace stria::coarse
