// Extremes, ranges and zones of the cycles that increments make.
#include "coarse/cycle/cycle_meter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/metered_cycles.hpp"

namespace stria::coarse {
namespace {

TEST_F(CycleMeterTest, EveryKHoldsThatOfTheInitialStress) {
    initial_K = 50.0;
    go(0, 20.0, 1.0, false);
    go(1, -10.0, 1.0, true, {{.tip = 0, .signal = 0, .closes = true, .load_factor = -6.0}});
    go(1, 20.0, 1.0, false, {{.tip = 0, .signal = 0, .closes = false, .load_factor = -4.0}});
    const CycleResult cycle = meter.finish().at(0);
    EXPECT_EQ(cycle.K_initial, 50.0);
    EXPECT_EQ(cycle.K_max, 250.0);
    EXPECT_EQ(cycle.K_min, -50.0);
    EXPECT_EQ(cycle.opening.K_cl, -10.0);
    EXPECT_EQ(cycle.opening.K_op, 10.0);
}

TEST_F(CycleMeterTest, MeasuresFromMaximumToMaximum) {
    go(0, 20.0, 1.0, false);
    go(1, 0.0, 1.0, true, {{.tip = 0, .signal = 0, .closes = true, .load_factor = 6.0}});
    go(1, 10.0, 1.0, false, {{.tip = 0, .signal = 0, .closes = false, .load_factor = 8.0}});
    go(1, 20.0, 1.0, false);
    const CycleResult cycle = meter.finish().at(0);
    EXPECT_EQ(cycle.K_max, 200.0);
    EXPECT_EQ(cycle.K_min, 0.0);
    EXPECT_EQ(cycle.opening.K_cl, 60.0);
    EXPECT_EQ(cycle.opening.K_op, 80.0);
    EXPECT_EQ(cycle.da, 0.0);
    EXPECT_NEAR(cycle.CTOD_range(), 0.02, 1e-15);
    EXPECT_NEAR(cycle.opening_range(), 0.04, 1e-15);
    EXPECT_NEAR(cycle.forward, 0.2, 1e-15);
}

// An overload counts once, in the cycle that reaches it. Nor does a crack count that grows at the load which was for
// the shorter one, by as much as a law makes of many cycles.
TEST_F(CycleMeterTest, TheMaximumThatItStartsFromIsThatOfTheCycleBefore) {
    for (const double start : {20.0, 30.0}) {
        meter = CycleMeter(input, closure, tips);
        go(0, start, 1.0, false);
        go(0, start, 1.25, false);  // grows
        go(1, 15.0, 1.25, false);
        go(1, 0.0, 1.25, false);
        go(1, 8.0, 1.25, false);
        go(1, 16.0, 1.25, false);
        const CycleResult cycle = meter.finish().at(0);
        EXPECT_EQ(cycle.K_max, 200.0);
        EXPECT_EQ(cycle.J_max, 16.0);
        EXPECT_NEAR(cycle.CTOD_range(), 0.016, 1e-15);
        EXPECT_NEAR(cycle.opening_range(), 0.032, 1e-15);
    }
}

// The load that counts passes falls while a load case lifts K (rolling contact).
TEST_F(CycleMeterTest, TakesTheLargestKWhereALoadCaseLiftsIt) {
    go(0, 20.0, 1.0, false);
    initial_K = 300.0;
    go(1, 10.0, 1.0, false);
    initial_K = 0.0;
    go(1, 0.0, 1.0, false);
    go(1, 20.0, 1.0, false);
    const CycleResult cycle = meter.finish().at(0);
    EXPECT_EQ(cycle.K_max, 400.0);
    EXPECT_EQ(cycle.K_min, 0.0);
}

// At three quarters of the way down, the first end of an increment, it was 250.
TEST_F(CycleMeterTest, TakesTheLeastWhereItStartsIfALoadCaseRunsAgainstTheLoad) {
    go(0, 10.0, 1.0, false);
    for (const double load : {25.0, 40.0, 30.0, 15.0}) go(1, load, 1.0, false);
    const CycleResult cycle = meter.finish().at(0);
    EXPECT_EQ(cycle.K_max, 400.0);
    EXPECT_EQ(cycle.K_min, 100.0);
    EXPECT_NEAR(cycle.CTOD_range(), 0.030, 1e-15);
    EXPECT_NEAR(cycle.opening_range(), 0.060, 1e-15);
}

// By 97 it was 138: a load that lags lifted K a little more behind an overload, and so much counted in the next cycle.
TEST_F(CycleMeterTest, LeavesWhatALoadThatLagsStillAddsToTheCycleBefore) {
    for (const bool soon : {true, false}) {
        meter = CycleMeter(input, closure, tips, true);
        initial_K = 0.0;
        go(0, 20.0, 1.0, false);
        moment = soon ? 0.2 : 0.3;
        initial_K = 300.0;
        go(1, 10.0, 1.0, false);
        moment = 0.4;
        initial_K = 100.0;
        go(1, 0.0, 1.0, false);
        moment = 1.0;
        go(1, 5.0, 1.0, false);
        const CycleResult cycle = meter.finish({-1e9}).at(0);
        EXPECT_EQ(cycle.K_max, soon ? 150.0 : 400.0) << "later it is its own";
        EXPECT_EQ(cycle.J_max, soon ? 5.0 : 10.0);
    }
    go(2, 5.0, 1.0, false);
    EXPECT_EQ(meter.finish({170.0}).at(0).K_max, 170.0);
}

// What is to come of this rise is not known yet, but for its K: where loads repeat it is what came of the one before.
TEST_F(CycleMeterTest, TakesTheRestOfTheRiseBeforeForItsOwnWhereItRisesAsHigh) {
    for (const double peak : {250.0, 240.0}) {
        meter = CycleMeter(input, closure, tips, true);
        initial_K = 0.0;
        go(0, 20.0, 1.0, false);
        moment = 0.2;
        initial_K = 60.0;
        J_of_load = 3.0;
        go(1, 19.0, 1.0, false);  // K = 250
        J_of_load = 1.0;
        moment = 0.4;
        initial_K = 0.0;
        go(1, 0.0, 1.0, true, {{.tip = 0, .signal = 0, .closes = true, .load_factor = 5.0}});
        moment = 1.0;
        go(1, 20.0, 1.0, true);
        const CycleResult cycle = meter.finish({peak}).at(0);
        EXPECT_EQ(cycle.J_max, peak == 250.0 ? 57.0 : 20.0);
        EXPECT_EQ(cycle.opening.lost, peak != 250.0) << "it may open yet";
    }
}

TEST_F(CycleMeterTest, LooksAheadToWhereKFalls) {
    Increment increment;
    for (const auto& [K_I, of_case] : {std::pair{10.0, 3.0}, {10.0, 8.0}, {-10.0, 3.0}})
        increment.nominal.push_back({.K_I = K_I, .K_initial = 1.0, .K_I_of_cases = {of_case}});
    std::vector<LoadFactors> loads;
    for (const auto& [main, beside] : {std::pair{10.0, 0.0}, {9.0, 4.0}, {7.0, 7.0}})
        loads.emplace_back(main, Eigen::VectorXd::Constant(1, beside));
    EXPECT_EQ(peaks_ahead(increment, loads), (std::vector<double>{103.0, -std::numeric_limits<double>::infinity(),
                                                                  -std::numeric_limits<double>::infinity()}));
    EXPECT_TRUE(peaks_ahead(increment, {}).empty());
}

// It was taken to rise from zero to the first target, and what flowed back was in the zone of loading.
TEST_F(CycleMeterTest, AControlledDisplacementFallsFromWhereOtherLoadsHaveMovedTheBoundary) {
    input.load.control = Control::Displacement;
    meter = CycleMeter(input, closure, tips);
    moved_to = 2.0;
    go(0, 0.0, 1.0, false);
    moved_to.reset();
    go(1, 1.0, 1.0, false);
    go(1, -1.0, 1.0, false);
    go(1, 0.0, 1.0, false);
    const CycleResult cycle = meter.finish().at(0);
    EXPECT_EQ(cycle.cyclic, 0.01);
    EXPECT_EQ(cycle.forward, 0.0);
}

// Of a crack in shear the mesh alone makes a K_I: what loading is says [load].
TEST_F(CycleMeterTest, ShearLoadsAsTheLoadDoes) {
    unit_K = -1e-3;
    unit_K_II = 10.0;
    go(0, 20.0, 1.0, true);
    go(1, 0.0, 1.0, true);
    go(1, 10.0, 1.0, false, {{.tip = 0, .signal = 0, .closes = false, .load_factor = 5.0}});
    go(1, 20.0, 1.0, false);
    const CycleResult result = meter.finish().at(0);
    EXPECT_NEAR(result.forward, 0.2, 1e-15);
    EXPECT_EQ(result.cyclic, 0.0);
    EXPECT_EQ(result.opening.K_op, -5e-3);
}

// They were 1e300 and -1e300, and the crack was arrested.
TEST_F(CycleMeterTest, KnowsNoExtremesOfKWhereNoRingHasToldOneOfThem) {
    for (const bool told_at_end : {false, true}) {
        told = true;
        go(0, 20.0, 1.0, false);
        told = false;
        go(1, 0.0, 1.0, false);
        go(1, 10.0, 1.0, false);
        told = told_at_end;
        go(1, 20.0, 1.0, false);
        const CycleResult cycle = meter.finish().at(0);
        for (const double K : {cycle.K_max, cycle.K_min, cycle.opening.K_op, cycle.opening.K_cl})
            EXPECT_TRUE(std::isnan(K)) << K;
        meter = CycleMeter(input, closure, tips);
    }
}

// Pressed faces that cannot touch overlap, and have the J of a crack that is pulled: by 160 increments it was 0.62 N/mm
// in a cycle to 0.36.
TEST_F(CycleMeterTest, TakesNoJOfFacesThatOverlap) {
    for (const bool touches : {true, false}) {
        input.cracks[0].contact.reset();
        if (touches) input.cracks[0].contact.emplace();
        meter = CycleMeter(input, closure, tips);
        go(0, 20.0, 1.0, false);
        go(1, -40.0, 1.0, false);
        J_of_load = -1.0;
        go(1, -30.0, 1.0, false);
        J_of_load = 1.0;
        go(1, 20.0, 1.0, false);
        EXPECT_EQ(meter.finish().at(0).J_max, touches ? 30.0 : 20.0);
    }
}

}  // namespace
}  // namespace stria::coarse
