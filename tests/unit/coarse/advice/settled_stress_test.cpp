// How much of the energy of an initial stress equilibrium leaves.
#include "coarse/advice/settled_stress.hpp"

#include <gtest/gtest.h>

#include "coarse/zone/refined_scene.hpp"
#include "tests/support/layered_plates.hpp"
#include "tests/support/pulled_plate.hpp"
#include "tests/support/refusal.hpp"

namespace stria::coarse {
namespace {

/// A square of 20 mm in plane stress, under sigma_yy between 30 MPa at its sides and -30 MPa in the middle. At the
/// centres of its elements of 2 mm that is 0.8, 0.4, 0, -0.4, -0.8 times as much: sigma_yy^2 / 2 E in each mm2.
class SettledStress : public testing::Test {
protected:
    SettledStress() {
        Case input = test::pulled_plate(2.0, false, false);
        input.model.plane = PlaneState::Stress;
        const StressProfile along_x{.at = {0.0, 10.0, 20.0}, .stress = {30.0, -30.0, 30.0}};
        input.initial_stress = InitialStressSection{.sigma_x = {}, .sigma_y = along_x, .file = {}, .grid = {}};
        scene = refined_scene(input);
    }
    void judge(double stored) {
        judge_settled_stress(scene, stored, [this](const std::string& text) { said = text; });
    }

    Scene scene;
    std::string said;
    const double given = 400.0 * 0.32 * 30.0 * 30.0 / (2.0 * 200e3);  // N
};

TEST_F(SettledStress, SaysWhichShareOfItsEnergyIsLeft) {
    judge(0.5 * given);
    EXPECT_EQ(said, "initial stress: equilibrium leaves 50 % of its energy");
}

TEST_F(SettledStress, IsNotSpokenOfWhereThereIsNone) {
    scene = refined_scene(test::pulled_plate(2.0, false, false));
    judge(1.0);
    EXPECT_EQ(said, "");
}

// The upper half is twice as stiff, and takes half of the energy for the same stress.
TEST_F(SettledStress, HasTheEnergyOfEachElementsMetal) {
    Case input = scene.input;
    input.regions = {test::region_of({{0.0, 10.0}, {20.0, 20.0}}, 400e3, 0.3)};
    scene = refined_scene(input);
    judge(0.75 * given);
    EXPECT_EQ(said, "initial stress: equilibrium leaves 100 % of its energy");
}

TEST_F(SettledStress, OfAFieldThatIsNotSelfEquilibratedIsRefused) {
    EXPECT_EQ(test::refusal_of([&] { judge(0.26 * given); }), "accepted");
    const std::string refusal = test::refusal_of([&] { judge(0.24 * given); });
    EXPECT_NE(refusal.find("leaves 24 % of its energy: the field is not self-equilibrated"), std::string::npos)
        << refusal;
    scene.input.initial_stress.reset();  // a misfit finds its own equilibrium
    EXPECT_EQ(test::refusal_of([&] { judge(0.24 * given); }), "accepted");
}

}  // namespace
}  // namespace stria::coarse
