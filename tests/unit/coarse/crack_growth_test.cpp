#include "coarse/crack_growth.hpp"

#include <gtest/gtest.h>

namespace stria::coarse {
namespace {

using stria::Vec2;

TEST(CrackGrowth, MovesTheEndOfAStraightCrackAndBendsAtACorner) {
    CrackSection crack{.points = {{0.0, 1.0}, {2.0, 1.0}}, .contact = {}};
    const Tip tip{.crack = 0, .position = {2.0, 1.0}, .direction = {1.0, 0.0}, .s = 2.0, .upper = 1};
    advance(crack, tip, {1.0, 0.0}, 0.25);
    ASSERT_EQ(crack.points.size(), 2U);
    EXPECT_EQ(crack.points[1], Vec2(2.25, 1.0));
    const Tip grown{.crack = 0, .position = {2.25, 1.0}, .direction = {1.0, 0.0}, .s = 2.25, .upper = 1};
    advance(crack, grown, {0.6, 0.8}, 0.5);
    ASSERT_EQ(crack.points.size(), 3U);
    EXPECT_LT((crack.points[2] - Vec2(2.55, 1.4)).norm(), 1e-15);
}

TEST(CrackGrowth, MovesTheFirstPointOfACrackThatStartsAtATip) {
    CrackSection crack{.points = {{1.0, 1.0}, {2.0, 1.0}}, .contact = {}};
    advance(crack, {.crack = 0, .position = {1.0, 1.0}, .direction = {-1.0, 0.0}, .s = 0.0, .upper = -1}, {-1.0, 0.0},
            0.25);
    EXPECT_EQ(crack.points.front(), Vec2(0.75, 1.0));
}

TEST(CrackGrowth, ComesWithTheCyclesAsked) {
    GrowthSection growth{.law = "prescribed", .increment = 0.1, .every = 2, .at = GrowthAt::Maximum};
    LoadStep step;
    step.cycle = 2;
    EXPECT_FALSE(grows_at(growth, step));
    step.ends_cycle = true;
    EXPECT_TRUE(grows_at(growth, step));
    step.cycle = 3;
    EXPECT_FALSE(grows_at(growth, step));
    growth = {.law = "prescribed", .increment = 0.1, .every = 1, .at = GrowthAt::Minimum};
    EXPECT_FALSE(grows_at(growth, step));
    step.at_minimum = true;
    EXPECT_TRUE(grows_at(growth, step));
    EXPECT_NEAR(planned_growth(growth, {.blocks = {{.cycles = 3}, {.cycles = 4}}}), 0.7, 1e-15);
}

}  // namespace
}  // namespace stria::coarse
