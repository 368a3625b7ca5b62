// Both modes of tips under loads that have been reached, and what friction hides of them.
#include "coarse/growth/modes_of_tip.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria::coarse {
namespace {

/// Two cracks with a tip each; nothing else of the scene matters.
Scene two_tips(double friction) {
    Scene scene;
    scene.input.cracks.resize(2);
    for (CrackSection& crack : scene.input.cracks) {
        crack.contact.emplace();
        crack.contact->friction = friction;
    }
    for (const int crack : {0, 1})
        scene.enriched.tips.push_back(
            {.crack = crack, .position = Vec2::Zero(), .direction = Vec2::UnitX(), .s = 0.0, .upper = 1});
    return scene;
}

const std::vector<TipResult> nominal{
    {.K_I = 10.0, .K_II = 2.0, .K_initial = 1.0, .K_II_initial = -3.0, .K_I_of_cases = {5.0}, .K_II_of_cases = {7.0}},
    {.K_I = 20.0, .K_II = 4.0, .K_I_of_cases = {0.0}, .K_II_of_cases = {0.0}}};
const LoadFactors loads{2.0, Eigen::VectorXd::Constant(1, 3.0)};

TEST(ModesOfTips, AreThoseOfAllLoadsTogether) {
    const std::vector<TipResult> under = nominal_under(loads, nominal);
    EXPECT_DOUBLE_EQ(under[0].K_I, 20.0 + 15.0 + 1.0);
    EXPECT_DOUBLE_EQ(under[0].K_II, 4.0 + 21.0 - 3.0);
    EXPECT_DOUBLE_EQ(sizes_of(under)[0], std::hypot(36.0, 22.0));
    EXPECT_EQ(under[1].K_I, 40.0);
}

TEST(ModesOfTips, HaveTheMeasuredSlidingOfFacesThatTouchAndNominalOpening) {
    std::vector<TipResult> measured{{.K_I = 30.0, .K_II = 6.0, .contact_length = 1.0}, {.K_I = 35.0, .K_II = 5.0}};
    const auto modes = modes_let_through(two_tips(0.3), nominal, loads, measured);
    EXPECT_EQ(modes[0], (ModesOfTip{36.0, 6.0}));
    EXPECT_EQ(modes[1], (ModesOfTip{40.0, 5.0}));
    measured[0].contact_length = 0.0;
    EXPECT_EQ(modes_let_through(two_tips(0.3), nominal, loads, measured)[0], (ModesOfTip{36.0, 22.0}));
}

// K that is next to nothing beside that of the loads turns no tip.
TEST(ModesOfTips, AreMeasuredAsPartsOfThoseOfTheLoads) {
    std::vector<TipResult> measured{{.K_II = 0.0049 * std::hypot(36.0, 22.0), .contact_length = 1.0}, {}};
    EXPECT_EQ(modes_let_through(two_tips(0.3), nominal, loads, measured)[0].K_II, 22.0);
    measured[0].K_II = 0.0051 * std::hypot(36.0, 22.0);
    EXPECT_EQ(modes_let_through(two_tips(0.3), nominal, loads, measured)[0].K_II, measured[0].K_II);
}

TEST(ModesOfTips, AreHiddenWhereFacesRubAndNoRingTells) {
    const std::vector<TipResult> measured{{.K_II = 6.0, .rings_flow = true, .contact_length = 1.0}, {}};
    EXPECT_TRUE(std::isnan(modes_let_through(two_tips(0.3), nominal, loads, measured)[0].K_II));
    EXPECT_EQ(modes_let_through(two_tips(0.0), nominal, loads, measured)[0].K_II, 22.0) << "nothing holds smooth faces";
    const std::vector<TipResult> apart{{.K_II = 6.0, .rings_flow = true, .contact_length = 0.0}, {}};
    EXPECT_EQ(modes_let_through(two_tips(0.3), nominal, loads, apart)[0].K_II, 22.0) << "nothing rubs";
}

// Both tips are of the second crack, and the first one is smooth.
TEST(ModesOfTips, AreThoseOfTheirOwnCrack) {
    Scene scene = two_tips(0.3);
    scene.input.cracks[0].contact->friction = 0.0;
    scene.enriched.tips[0].crack = 1;
    const std::vector<TipResult> measured{{.K_II = 6.0, .rings_flow = true, .contact_length = 1.0}, {}};
    EXPECT_TRUE(std::isnan(modes_let_through(scene, nominal, loads, measured)[0].K_II));
    std::vector<ModesOfTip> modes{{1.0, 2.0}, {3.0, 4.0}};
    lengthen(modes, scene, nominal, loads);
    EXPECT_EQ(modes[0], (ModesOfTip{36.0, 2.0}));
}

TEST(ModesOfTips, OfLongerCracksKeepWhatFrictionLetThrough) {
    std::vector<ModesOfTip> rough{{1.0, 2.0}, {3.0, 4.0}}, smooth = rough;
    lengthen(rough, two_tips(0.3), nominal, loads);
    lengthen(smooth, two_tips(0.0), nominal, loads);
    EXPECT_EQ(rough[0], (ModesOfTip{36.0, 2.0}));
    EXPECT_EQ(smooth[0], (ModesOfTip{36.0, 22.0}));
}

TEST(ModesOfTips, PressNoFacesThatTouch) {
    CrackSection crack;
    EXPECT_EQ(tip_with({-1.0, 2.0}, crack).K_I, -1.0);
    EXPECT_FALSE(is_rough(crack));
    crack.contact.emplace();
    EXPECT_EQ(tip_with({-1.0, 2.0}, crack).K_I, 0.0);
    EXPECT_EQ(tip_with({-1.0, 2.0}, crack).K_II, 2.0);
}

}  // namespace
}  // namespace stria::coarse
