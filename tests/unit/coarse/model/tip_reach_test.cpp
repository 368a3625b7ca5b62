// How far behind a tip its crack counts as straight.
#include "coarse/model/tip_reach.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria::coarse {
namespace {

// The tip at the origin looks along x. Behind it the crack dips to -0.1 and then rises to 0.5.
CrackSection dipping_crack() {
    CrackSection crack;
    crack.points = {{-5.0, 0.5}, {-2.0, -0.1}, {-1.0, 0.0}, {0.0, 0.0}};
    return crack;
}

Tip tip_at_origin() {
    Tip tip;
    tip.crack = 0;
    tip.upper = 1;
    tip.position = {0.0, 0.0};
    tip.direction = {1.0, 0.0};
    return tip;
}

TEST(TipReach, EndsWhereTheCrackLeavesTheBandOnItsOtherSide) {
    // From -0.1 up to 0.2 is half of the way to 0.5.
    EXPECT_NEAR(straight_length(dipping_crack(), tip_at_origin(), 0.2), std::hypot(3.5, 0.2), 1e-12);
}

TEST(TipReach, DoesNotFeelAFurtherPointOfAStraightStretch) {
    CrackSection crack = dipping_crack();
    crack.points.insert(crack.points.begin() + 1, {-4.0, 0.3});
    EXPECT_NEAR(straight_length(crack, tip_at_origin(), 0.2), std::hypot(3.5, 0.2), 1e-12);
}

// The crack turns twice and comes back beside its tip: its faces there bound the rings, too.
TEST(TipReach, EndsAtAStretchOfTheSameCrackThatComesBack) {
    Mesh far_away;
    far_away.nodes = {{-100.0, -100.0}, {100.0, -100.0}};
    CrackSection hook;
    hook.points = {{6.0, -4.0}, {-8.0, -4.0}, {-8.0, 0.0}, {0.0, 0.0}};
    const Tip tip = tip_at_origin();
    EXPECT_NEAR(tip_reach(far_away, {hook}, std::span(&tip, 1), 0, 0.2), 4.0, 1e-12);
    hook.points = {{-8.0, -9.0}, {-8.0, 0.0}, {0.0, 0.0}};
    EXPECT_NEAR(tip_reach(far_away, {hook}, std::span(&tip, 1), 0, 0.2), std::hypot(8.0, 0.2), 1e-12);
}

}  // namespace
}  // namespace stria::coarse
