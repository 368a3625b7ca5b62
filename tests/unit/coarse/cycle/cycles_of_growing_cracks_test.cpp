// Extremes, ranges and zones of cycles within which a crack grows.
#include "coarse/cycle/cycle_meter.hpp"

#include <gtest/gtest.h>

#include "tests/support/load_cases.hpp"
#include "tests/support/metered_cycles.hpp"

namespace stria::coarse {
namespace {

TEST_F(CycleMeterTest, StartsWithTheCrackAsItHasGrown) {
    go(0, 20.0, 1.0, false);
    go(1, 0.0, 1.0, false);
    go(1, 20.0, 1.0, false);
    EXPECT_EQ(meter.finish().at(0).opening.K_op, 0.0);  // open all cycle
    go(1, 20.0, 1.5, false);                            // grows
    go(2, 0.0, 1.5, false);
    go(2, 20.0, 1.5, false);
    const CycleResult cycle = meter.finish().at(0);
    EXPECT_EQ(cycle.da, 0.5);
    EXPECT_EQ(cycle.K_max, 300.0);
    EXPECT_NEAR(cycle.forward, 0.2, 1e-15);  // the flow of growing is of loading
    EXPECT_EQ(cycle.cyclic, 0.0);
}

// `a` is half of a crack with two tips, and one of them may be the faster one.
TEST_F(CycleMeterTest, ATipGrowsByItsOwnWay) {
    way = 1.5;
    go(0, 20.0, 1.0, false);
    go(1, 0.0, 1.0, false);
    bend = 1e-13;  // the other one has gone its way: rounding
    go(1, 20.0, 1.0, false);
    EXPECT_EQ(meter.finish().at(0).da, 0.0);
    bend = 0.125;             // it turns on its way
    go(1, 20.0, 1.5, false);  // grows
    go(2, 0.0, 1.5, false);
    go(2, 20.0, 1.5, false);
    const CycleResult cycle = meter.finish().at(0);
    EXPECT_EQ(cycle.a, 1.5);
    EXPECT_NEAR(cycle.da, 0.875, 1e-12);
}

// Many cycles between the same loads, each with the crack as it is in them.
TEST_F(CycleMeterTest, GrowthAtAMinimumLeavesTheKOfTheLongerCrackThere) {
    go(0, 20.0, 1.0, false);
    go(1, 10.0, 1.0, false);
    go(1, 10.0, 1.5, false);  // grows
    go(1, 20.0, 1.5, false);
    const CycleResult cycle = meter.finish().at(0);
    EXPECT_EQ(cycle.K_max, 300.0);
    EXPECT_EQ(cycle.K_min, 150.0);
}

// There a load is K / K_1(a) of the length at which the way to it begins, and K is what many cycles hold.
TEST_F(CycleMeterTest, UnderControlOfKGrowthAtAMinimumLeavesTheKAskedFor) {
    input.load.control = Control::StressIntensity;
    meter = CycleMeter(input, closure, tips);
    go(0, 20.0, 1.0, false);
    go(1, 10.0, 1.0, false);
    go(1, 10.0, 1.25, false);  // grows
    go(1, 16.0, 1.25, false);
    const CycleResult cycle = meter.finish().at(0);
    EXPECT_EQ(cycle.K_max, 200.0);
    EXPECT_EQ(cycle.K_min, 100.0);
}

// A distance behind the tip is another place once it has moved. Of the K that is asked of the longer crack 6.4 makes as
// much as 8 did.
TEST_F(CycleMeterTest, RangesBehindATipThatGrowsAtAMinimumAreOfTheLongerCrack) {
    for (const Control control : {Control::Load, Control::StressIntensity}) {
        input.load.control = control;
        meter = CycleMeter(input, closure, tips);
        go(0, 20.0, 1.0, false);
        go(1, 8.0, 1.0, false);
        opening_at_tip = 3e-3;    // of new faces
        go(1, 8.0, 1.25, false);  // grows
        go(1, 16.0, 1.25, false);
        const double least = control == Control::Load ? 8.0 : 6.4;
        EXPECT_NEAR(meter.finish().at(0).opening_range(), 2e-3 * (16.0 - least), 1e-15);
        opening_at_tip = 0.0;
    }
}

// The minimum of the load is not that of K: what was less before the crack grew there stays.
TEST_F(CycleMeterTest, GrowthAtAMinimumKeepsALeastKThatIsElsewhere) {
    go(0, 10.0, 1.0, false);
    go(1, 40.0, 1.0, false);
    go(1, 40.0, 1.25, false);  // grows
    go(1, 10.0, 1.25, false);
    go(2, 40.0, 1.25, false);
    go(2, 40.0, 1.5, false);
    go(2, 20.0, 1.5, false);
    EXPECT_EQ(meter.finish().at(0).K_min, 125.0);
}

// A residual stress that the crack leaves: K falls as it grows.
TEST_F(CycleMeterTest, EndsWithTheKOfTheLongerCrack) {
    initial_K = 50.0;
    go(0, 20.0, 1.0, false);
    initial_K = 10.0;
    go(0, 20.0, 1.1, false);  // grows
    go(1, 0.0, 1.1, false);
    go(1, 20.0, 1.1, false);
    EXPECT_EQ(meter.finish().at(0).K_max, 230.0);
}

TEST_F(CycleMeterTest, FlowOfGrowthIsOfTheHalfCycleThatItEnds) {
    unit_K = -10.0;
    go(0, 20.0, 1.0, true);
    go(1, -20.0, 1.0, false);
    go(1, 20.0, 1.0, true);
    meter.finish();
    go(1, 20.0, 1.5, true);  // grows where K is least
    go(2, -20.0, 1.5, false);
    go(2, 10.0, 1.5, true);
    const CycleResult result = meter.finish().at(0);
    EXPECT_NEAR(result.cyclic, 0.2, 1e-15);
    EXPECT_EQ(result.forward, 0.0);
}

// Its K was that of the shorter crack beside it: 50 instead of 100.
TEST_F(CycleMeterTest, LoadingBeginsWithTheLongerCrackAtATipThatStandsToo) {
    is_beside_another = true;
    closure = ClosureMeter(input.closure, {300.0, 300.0}, input.cracks, {500.0, 500.0});
    meter = CycleMeter(input, closure, {tips[0], tips[0]});
    go(0, 20.0, 1.0, false);
    go(1, 5.0, 1.0, false);
    go(1, 5.0, 2.0, false);  // grows
    go(1, 20.0, 2.0, false);
    for (const CycleResult& cycle : meter.finish()) EXPECT_EQ(cycle.K_min, 100.0);
}

// A load case that follows [load] goes with the K that is asked of the longer crack, a dead load stays.
TEST_F(CycleMeterTest, LoadingBeginsWithTheKThatIsAskedOfTheLongerCrack) {
    input.load.control = Control::StressIntensity;
    input.load_cases = {test::lagging_load("follows", 0.5), test::dead_load("dead", 1.0)};
    meter = CycleMeter(input, closure, tips);
    const auto with_cases = [&](int cycle, double load, double a) {
        cases = Eigen::Vector2d(0.5 * load, 1.0);
        go(cycle, load, a, false);
    };
    with_cases(0, 20.0, 1.0);
    with_cases(1, 5.0, 1.0);
    with_cases(1, 5.0, 2.0);  // grows
    with_cases(1, 10.0, 2.0);
    const CycleResult cycle = meter.finish().at(0);
    EXPECT_DOUBLE_EQ(cycle.K_min, 50.0 + 25.0 + 20.0);
    EXPECT_DOUBLE_EQ(cycle.K_max, 200.0 + 100.0 + 20.0);
}

}  // namespace
}  // namespace stria::coarse
