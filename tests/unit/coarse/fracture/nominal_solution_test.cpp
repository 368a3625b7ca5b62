// The nominal solution: near elements tell its K; only the displacement of far ones is missing.
#include "coarse/fracture/nominal_solution.hpp"

#include <gtest/gtest.h>

#include "coarse/zone/refined_scene.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

TEST(NominalSolution, HasItsKFromNearElementsAlone) {
    Case input = test::pulled_plate(0.5, false, false);
    input.mesh.width = input.mesh.height = 40.0;
    input.cracks[0].points = {{0.0, 20.2}, {7.3, 20.2}};
    const Scene scene = refined_scene(input);
    const NominalSolution whole = solve_nominal(scene), near = solve_nominal_near(std::make_unique<Structure>(scene));
    ASSERT_EQ(whole.tips.size(), 1U);
    EXPECT_NE(whole.structure->factors().far, nullptr);
    EXPECT_NEAR(near.tips[0].K_I, whole.tips[0].K_I, 1e-10 * whole.tips[0].K_I);
    EXPECT_NEAR(near.tips[0].J, whole.tips[0].J, 1e-10 * whole.tips[0].J);
    EXPECT_LT(near.displacement.norm(), 0.9 * whole.displacement.norm());
}

}  // namespace
}  // namespace stria::coarse
