// Cycles from the increments that make them.
#include "coarse/cycle/cycle_meter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "tests/support/load_cases.hpp"

namespace stria::coarse {
namespace {

class CycleMeterTest : public testing::Test {
protected:
    CycleMeterTest() {
        input.material.yield_stress = 300.0;
        closure = ClosureMeter(input.closure, {300.0}, input.cracks, {500.0});
        input.cracks.emplace_back().contact.emplace();
        meter = CycleMeter(input, closure, tips);
    }

    /// At a load of the crack `a` long.
    void go(int cycle, double load, double a, bool is_closed, std::vector<OpeningChange> changes = {}) {
        Increment increment;
        increment.step.cycle = cycle;
        increment.step.moment = moment;
        if (input.load.control == Control::Displacement && !moved_to)
            increment.step.target.control = Control::Displacement;
        increment.machine.displacement = moved_to.value_or(load);
        increment.step.target.value = increment.load_factor = load;
        increment.cases_before = std::exchange(cases_before, cases);
        increment.step.target.cases = cases;
        increment.nominal = {{.K_I = told ? unit_K * a : NAN, .K_II = unit_K_II, .K_initial = initial_K}};
        increment.nominal[0].K_I_of_cases.assign(static_cast<std::size_t>(cases.size()), 10.0 * a);
        increment.signal.assign(closure.signals().all(), is_closed ? 1.0 : -1.0);
        increment.opening_changes = std::move(changes);
        increment.tips.push_back({.a = a,
                                  .x = way * a,
                                  .way = bend + way * a,
                                  .J = J_of_load * load,
                                  .CTOD = 1e-3 * load,
                                  .CMOD = mouth_of_load ? mouth_of_load(load) : load,
                                  .opening = 2e-3 * load + opening_at_tip,
                                  .plastic_zone = 0.01 * load});
        if (is_beside_another) {
            increment.nominal.push_back(increment.nominal[0]);
            increment.signal.insert(increment.signal.end(), increment.signal.begin(), increment.signal.end());
            increment.tips.push_back({.a = 3.0});
        }
        meter.add(increment);
    }

    Case input;
    ClosureMeter closure;
    CycleMeter meter;
    const std::vector<Tip> tips{{0, Vec2::Zero(), Vec2::UnitX(), 1.0, 0}};
    double unit_K = 10.0, unit_K_II = 0.0;  // of a crack of 1 mm
    Eigen::VectorXd cases, cases_before;    // factors of load cases
    double initial_K = 0.0, way = 1.0;      // of the tip, over the length that the crack is said to have
    double bend = 0.0;                      // mm: by so much its way is longer than straight
    double opening_at_tip = 0.0;            // beside what the load makes
    bool is_beside_another = false;         // tip, which stands, and has the same K
    bool told = true;                       // K, by a ring
    double J_of_load = 1.0;
    std::function<double(double)> mouth_of_load;  // mm; absent: the load
    double moment = 1.0;                          // cycles
    std::optional<double> moved_to;               // mm, the boundary, by what is no displacement controlled
};

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

TEST_F(CycleMeterTest, ClosesWithTheFirstContactAndOpensWithTheLast) {
    const auto change = [](bool closes, double load) { return OpeningChange{0, 0, closes, load}; };
    go(0, 20.0, 1.0, false);
    go(1, 10.0, 1.0, true, {change(true, 12.0)});
    go(1, 5.0, 1.0, true, {change(false, 8.0), change(true, 6.0)});
    go(1, 0.0, 1.0, true);
    go(1, 10.0, 1.0, true, {change(false, 3.0), change(true, 4.0)});
    go(1, 20.0, 1.0, false, {change(false, 14.0)});
    const CycleResult cycle = meter.finish().at(0);
    EXPECT_EQ(cycle.opening.K_cl, 120.0);
    EXPECT_EQ(cycle.opening.K_op, 140.0);
    EXPECT_FALSE(cycle.opening.lost);
}

// Faces that never touch overlap below zero: that they are open all cycle made dK_eff at R = -1 twice the range in
// tension.
TEST_F(CycleMeterTest, WithoutContactOnlyTensionIsEffective) {
    input.cracks[0].contact.reset();
    meter = CycleMeter(input, closure, tips);
    const auto opens = [&](double max, double min) {
        go(0, max, 1.0, false);
        go(1, min, 1.0, false);
        go(1, max, 1.0, false);
        const CycleResult cycle = meter.finish().at(0);
        EXPECT_EQ(cycle.opening.K_cl, cycle.opening.K_op);
        return cycle.opening.K_op;
    };
    EXPECT_EQ(opens(20.0, -20.0), 0.0);
    meter = CycleMeter(input, closure, tips);
    EXPECT_EQ(opens(20.0, 5.0), 50.0);
    meter = CycleMeter(input, closure, tips);
    EXPECT_EQ(opens(-5.0, -20.0), -50.0);  // nothing is left
}

// K_op is of loading: contact that is lost on the way down is lost there already.
TEST_F(CycleMeterTest, ContactLostInUnloadingOpensNoCrackInLoading) {
    const auto change = [](bool closes, double load) { return OpeningChange{0, 0, closes, load}; };
    go(0, 20.0, 1.0, false);
    go(1, 8.0, 1.0, false, {change(true, 12.0), change(false, 9.0)});
    go(1, 5.0, 1.0, false);
    go(1, 20.0, 1.0, false);
    OpeningLoads loads = meter.finish().at(0).opening;
    EXPECT_EQ(loads.K_cl, 120.0);
    EXPECT_EQ(loads.K_op, 50.0);  // the minimum: open all the way up
    go(2, 8.0, 1.0, false, {change(true, 12.0), change(false, std::nan(""))});
    go(2, 5.0, 1.0, true, {change(true, 6.0)});
    go(2, 20.0, 1.0, true);
    loads = meter.finish().at(0).opening;
    EXPECT_TRUE(std::isnan(loads.K_op));  // closed all the way up
    EXPECT_FALSE(loads.lost);
    go(3, 5.0, 1.0, false, {change(false, 9.0)});
    go(3, 20.0, 1.0, false, {change(true, 10.0), change(false, 15.0)});
    EXPECT_EQ(meter.finish().at(0).opening.K_op, 150.0);
}

// A plate is bent, and this crack lies where the other side is pulled. It was said to open at its largest K, and what
// flows as it opens to be the zone of unloading.
TEST_F(CycleMeterTest, ATipThatOpensAsTheLoadFallsHasItsOpeningLoads) {
    unit_K = -10.0;
    go(0, 20.0, 1.0, true);
    for (const int cycle : {1, 2}) {
        go(cycle, 8.0, 1.0, true);
        go(cycle, -20.0, 1.0, false, {{.tip = 0, .signal = 0, .closes = false, .load_factor = -4.0}});
        go(cycle, -10.0, 1.0, false);
        go(cycle, 20.0, 1.0, true, {{.tip = 0, .signal = 0, .closes = true, .load_factor = -3.0}});
        const CycleResult result = meter.finish().at(0);
        EXPECT_EQ(result.K_max, 200.0);
        EXPECT_EQ(result.K_min, -200.0);
        EXPECT_EQ(result.opening.K_op, 40.0);
        EXPECT_EQ(result.opening.K_cl, 30.0);
        EXPECT_NEAR(result.forward, 0.08, 1e-15);
        EXPECT_NEAR(result.cyclic, 0.2, 1e-15);
    }
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

// Its K was taken to rise as the displacement did, and K_op was that of no rise.
TEST_F(CycleMeterTest, ALoadCaseOpensATipThoughADisplacementIsControlled) {
    input.load.control = Control::Displacement;
    meter = CycleMeter(input, closure, tips);
    const auto go_to = [&](double factor, double load, bool is_closed, std::vector<OpeningChange> changes = {}) {
        cases = Eigen::VectorXd::Constant(1, factor);
        go(1, load, 1.0, is_closed, std::move(changes));
    };
    cases = Eigen::VectorXd::Zero(1);
    go(0, 2.0, 1.0, false);
    go_to(-20.0, 1.0, true, {{.tip = 0, .signal = 0, .closes = true, .load_factor = 1.5, .way = 0.25}});
    go_to(20.0, 0.0, false, {{.tip = 0, .signal = 0, .closes = false, .load_factor = 0.5, .way = 0.5}});
    go_to(0.0, 1.0, false);
    go_to(-5.0, 2.0, false);
    const CycleResult cycle = meter.finish().at(0);
    EXPECT_EQ(cycle.K_max, 200.0);
    EXPECT_EQ(cycle.opening.K_op, 5.0);
    EXPECT_EQ(cycle.opening.K_cl, -35.0);
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

// Nobody looks for contact on the ramp: what is open at its end has been so from where it was open first.
TEST_F(CycleMeterTest, ARiseThatTheRampBeginsOpensWhereTheRampDoes) {
    for (const double initial : {0.0, 30.0}) {
        initial_K = initial;
        meter = CycleMeter(input, closure, tips);
        cases = cases_before = Eigen::VectorXd::Zero(1);
        go(0, 8.0, 1.0, false);
        go(0, 10.0, 1.0, false);
        moment = 0.4;
        cases[0] = 30.0;
        go(1, 5.0, 1.0, false);
        cases[0] = -40.0;
        go(1, 0.0, 1.0, true, {{.tip = 0, .signal = 0, .closes = true, .load_factor = 1.0, .way = 0.8}});
        go(1, 5.0, 1.0, true);
        EXPECT_EQ(meter.finish().at(0).opening.K_op, initial);
    }
}

// The slope at the mouth is that of the open crack as far as a load of -8.
TEST_F(CycleMeterTest, ATipThatOpensAsTheLoadFallsHasAnOffset) {
    const auto of_a_cycle = [&](double sense) {
        unit_K = 10.0 * sense;
        meter = CycleMeter(input, closure, tips);
        mouth_of_load = [&](double load) { return std::max(sense * load - 8.0, 0.0) + 0.2 * sense * load; };
        const auto go_to = [&](int load) { go(1, sense * load, 1.0, false); };
        go(0, sense > 0.0 ? 20.0 : 0.0, 1.0, false);
        if (sense > 0.0)
            for (int load = 19; load >= 0; --load) go_to(load);
        for (int load = 1; load <= 20; ++load) go_to(load);
        if (sense < 0.0)
            for (int load = 19; load >= 0; --load) go_to(load);
        return meter.finish().at(0).offset.K_op;
    };
    const double K_op = of_a_cycle(1.0);
    EXPECT_NEAR(K_op, 80.0, 10.0);
    mouth_of_load = {};
    EXPECT_NEAR(of_a_cycle(-1.0), K_op, 1e-9);
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

TEST_F(CycleMeterTest, LosesAnOpeningLoadThatNobodyFound) {
    go(0, 20.0, 1.0, false);
    go(1, 0.0, 1.0, true, {{.tip = 0, .signal = 0, .closes = true, .load_factor = 6.0}});
    go(1, 20.0, 1.0, false, {{.tip = 0, .signal = 0, .closes = false, .load_factor = std::nan("")}});
    const CycleResult cycle = meter.finish().at(0);
    EXPECT_TRUE(std::isnan(cycle.opening.K_op));
    EXPECT_TRUE(cycle.opening.lost);
    EXPECT_EQ(cycle.opening.K_cl, 60.0);
}

// Closed on the way down, and open at the minimum, where rounding says so or a growth has put the tip elsewhere.
TEST_F(CycleMeterTest, OpensAtTheMinimumWhereNoLoadTellsSo) {
    go(0, 20.0, 1.0, false);
    go(1, 0.0, 1.0, false, {{.tip = 0, .signal = 0, .closes = true, .load_factor = 2.0}});
    go(1, 20.0, 1.0, false);
    const OpeningLoads by_rounding = meter.finish().at(0).opening;
    EXPECT_EQ(by_rounding.K_cl, 20.0);
    EXPECT_EQ(by_rounding.K_op, 0.0);
    go(2, 5.0, 1.0, true, {{.tip = 0, .signal = 0, .closes = true, .load_factor = 8.0}});
    go(2, 5.0, 2.0, false);  // grows
    go(2, 20.0, 2.0, false);
    const CycleResult grown = meter.finish().at(0);
    EXPECT_EQ(grown.K_min, 100.0);
    EXPECT_EQ(grown.opening.K_op, 100.0);
    go(3, 5.0, 2.0, true, {{.tip = 0, .signal = 0, .closes = true, .load_factor = 8.0}});
    go(3, 20.0, 2.0, false, {{.tip = 0, .signal = 0, .closes = false, .load_factor = 6.0}});
    EXPECT_EQ(meter.finish().at(0).opening.K_op, 120.0);
}

TEST_F(CycleMeterTest, ClosesAtTheMinimumWhereNoLoadTellsSo) {
    go(0, 20.0, 1.0, false);
    go(1, 10.0, 1.0, false);
    go(1, 0.0, 1.0, true);
    go(1, 20.0, 1.0, false, {{.tip = 0, .signal = 0, .closes = false, .load_factor = 1.0}});
    const OpeningLoads loads = meter.finish().at(0).opening;
    EXPECT_EQ(loads.K_cl, 0.0);
    EXPECT_EQ(loads.K_op, 10.0);
    go(2, 5.0, 1.0, false);
    go(2, 5.0, 2.0, true);  // grows
    go(2, 20.0, 2.0, false, {{.tip = 0, .signal = 0, .closes = false, .load_factor = 6.0}});
    const CycleResult grown = meter.finish().at(0);
    EXPECT_EQ(grown.opening.K_cl, grown.K_min);
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

TEST_F(CycleMeterTest, TakesTheFirstSlipOfEachHalfCycle) {
    input.closure.profile = {0.5};
    input.cracks.resize(1);
    input.cracks[0].contact = ContactSection{0.3};
    closure = ClosureMeter(input.closure, {300.0}, input.cracks, {500.0});
    meter = CycleMeter(input, closure, tips);
    go(0, 20.0, 1.0, true);
    const auto slides = [](int distance, double load) { return OpeningChange{0, 2 + distance, true, load}; };
    for (const int cycle : {1, 2}) {
        go(cycle, 0.0, 1.0, true, {slides(0, 15.0), slides(0, 14.0)});
        go(cycle, 10.0, 1.0, true, {slides(0, 6.0), slides(0, 7.0)});
        go(cycle, 20.0, 1.0, true, cycle == 1 ? std::vector{slides(1, 12.0)} : std::vector<OpeningChange>());
        const CycleResult result = meter.finish().at(0);
        ASSERT_EQ(result.K_slip.size(), 2U);
        EXPECT_EQ(result.K_slip[0], 60.0);
        EXPECT_EQ(result.K_slip_unloading.at(0), 150.0);
        EXPECT_TRUE(std::isnan(result.K_slip_unloading.at(1)));
        EXPECT_TRUE(cycle == 1 ? result.K_slip[1] == 120.0 : std::isnan(result.K_slip[1]));
        EXPECT_EQ(result.contact.size(), 2U);
    }
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

TEST_F(CycleMeterTest, SaysNothingOfACrackThatStaysClosed) {
    go(0, 20.0, 1.0, true);
    go(1, 0.0, 1.0, true);
    go(1, 20.0, 1.0, true);
    EXPECT_TRUE(std::isnan(meter.finish().at(0).opening.K_op));
}

}  // namespace
}  // namespace stria::coarse
