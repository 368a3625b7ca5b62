// Opening, closing and slip in the cycles that increments make.
#include "coarse/cycle/cycle_meter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/load_cases.hpp"
#include "tests/support/metered_cycles.hpp"

namespace stria::coarse {
namespace {

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

TEST_F(CycleMeterTest, SaysNothingOfACrackThatStaysClosed) {
    go(0, 20.0, 1.0, true);
    go(1, 0.0, 1.0, true);
    go(1, 20.0, 1.0, true);
    EXPECT_TRUE(std::isnan(meter.finish().at(0).opening.K_op));
}

// The mouth follows the boundary, and the body is stiffer where faces touch: below 8.
TEST_F(CycleMeterTest, TheComplianceIsThatOfTheForceWhereABoundaryIsMoved) {
    force_of_load = [](double moved) { return moved > 8.0 ? moved : 8.0 - 1.2 * (8.0 - moved); };
    input.boundaries.emplace_back().displacement = {std::nullopt, 1.0};
    meter = CycleMeter(input, closure, tips);
    for (int load = 1; load <= 20; ++load) go(0, load, 1.0, false);
    for (int load = 19; load >= 0; --load) go(1, load, 1.0, false);
    for (int load = 1; load <= 20; ++load) go(1, load, 1.0, false);
    EXPECT_NEAR(meter.finish().at(0).offset.K_op, 80.0, 10.0);
}

}  // namespace
}  // namespace stria::coarse
