// The K that tips may break by.
#include "coarse/growth/tip_break.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria::coarse {
namespace {

/// One crack with a tip.
Scene one_tip() {
    Scene scene;
    scene.input.cracks.resize(1);
    scene.enriched.tips.push_back(
        {.crack = 0, .position = Vec2::Zero(), .direction = Vec2::UnitX(), .s = 0.0, .upper = 1});
    return scene;
}

double K_of(const ModesOfTip& modes, GrowthDirection direction = GrowthDirection::HoopStress) {
    return K_of_break(one_tip(), direction, {modes}).at(0);
}

TEST(TipBreak, IsByKIWhereNothingTurnsTheTip) {
    EXPECT_EQ(K_of({50.0, 0.0}), 50.0);
    EXPECT_EQ(K_of({50.0, 1.0}), 50.0) << "no sharp turn";
}

// Pure mode II: 70.5 degrees, K_I = 2 / sqrt(3) K_II.
TEST(TipBreak, IsByTheKBehindASharpTurn) {
    EXPECT_NEAR(K_of({0.0, 60.0}), 60.0 * 2.0 / std::sqrt(3.0), 1e-4);
    EXPECT_NEAR(K_of({0.0, -60.0}), 60.0 * 2.0 / std::sqrt(3.0), 1e-4);
    EXPECT_EQ(K_of({5.0, 60.0}, GrowthDirection::Straight), 5.0);
}

// Faces that touch take the pressure, and what slides behind them is a tip in pure mode II.
TEST(TipBreak, OfATipThatIsPressedIsThatOfItsOwnFaces) {
    Scene scene = one_tip();
    scene.input.cracks.resize(2);
    scene.input.cracks[1].contact.emplace();
    scene.enriched.tips[0].crack = 1;
    const std::vector<ModesOfTip> pressed{{-50.0, 60.0}};
    EXPECT_NEAR(K_of_break(scene, GrowthDirection::HoopStress, pressed).at(0), 60.0 * 2.0 / std::sqrt(3.0), 1e-4);
    EXPECT_LT(K_of(pressed[0]), 50.0) << "without contact";
}

TEST(TipBreak, IsByKIWhereNoRingTellsKII) { EXPECT_EQ(K_of({50.0, std::nan("")}), 50.0); }

}  // namespace
}  // namespace stria::coarse
