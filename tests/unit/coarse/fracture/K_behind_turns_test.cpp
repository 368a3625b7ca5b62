// The K of tips once they have turned.
#include "coarse/fracture/K_behind_turns.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coarse/fracture/turned_tip.hpp"

namespace stria::coarse {
namespace {

/// Two tips that are pulled and sheared, a third that is sheared and pressed.
struct KBehindTurns : testing::Test {
    Case input = [] {
        Case pulled;
        pulled.load.blocks = {{.cycles = 9, .max = 2.0, .min = 0.0}, {.max = 3.0, .min = 0.0}};
        return pulled;
    }();
    const UnitResponse unit{.K_I = {30.0, 30.0, -30.0}, .K_II = {-30.0, 1.0, 10.0}};
    const double of_first = 3.0 * K_just_turned({.K_I = 30.0, .K_II = 30.0}, hoop_stress_angle(30.0, 30.0)),
                 of_last = 3.0 * 10.0 * 2.0 / std::sqrt(3.0);
};

TEST_F(KBehindTurns, IsKOfTensionWhereNoneTurns) {
    EXPECT_EQ(largest_K_behind_turns(input, unit), (std::vector<double>{90.0, 90.0, 0.0}));
    input.growth = GrowthSection{.increment = 0.1, .direction = GrowthDirection::Straight};
    EXPECT_EQ(largest_K_behind_turns(input, unit), (std::vector<double>{90.0, 90.0, 0.0}));
}

TEST_F(KBehindTurns, IsThatOfTheLargestHoopStressOfTipsThatTurnSharply) {
    input.growth = GrowthSection{.increment = 0.1};
    const std::vector<double> K = largest_K_behind_turns(input, unit), usual = common_K_behind_turns(input, unit);
    EXPECT_GT(of_first, 1.5 * 90.0);
    EXPECT_NEAR(K[0], of_first, 1e-9);
    EXPECT_EQ(K[1], 90.0) << "by less than sharp_turn";
    EXPECT_NEAR(K[2], of_last, 1e-9);
    EXPECT_NEAR(usual[0], of_first / 1.5, 1e-9) << "the cycles of 2 make most of the growth";
    EXPECT_NEAR(usual[1], 60.0, 1e-9);
}

// Of a crack at 80 degrees across which hardly anything pulls the default was a ten thousandth of what its K asks for
// once it has turned.
TEST_F(KBehindTurns, GivesTheDistanceOfClosure) {
    EXPECT_EQ(K_of_closure(input, unit)[0], 90.0);
    EXPECT_DOUBLE_EQ(K_of_closure(input, unit)[2], 30.0 * std::sqrt(3.0)) << "nothing opens it";
    input.growth = GrowthSection{.increment = 0.1};
    EXPECT_NEAR(K_of_closure(input, unit)[0], of_first, 1e-9);
    EXPECT_EQ(K_of_closure(input, unit)[1], 90.0);
    EXPECT_NEAR(K_of_closure(input, unit)[2], of_last, 1e-9);
}

}  // namespace
}  // namespace stria::coarse
