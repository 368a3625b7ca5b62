// Where faces begin to slide between two states, found by trying.
#include "coarse/cycle/closure_meter.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "common/index.hpp"
#include "tests/support/closure_reports.hpp"

namespace stria::coarse {
namespace {

TEST(ClosureMeter, AsksForSlipWhereThereIsFrictionAndAProfile) {
    const ClosureMeter meter(rough().closure, {300.0}, rough().cracks, {500.0});
    EXPECT_EQ(meter.signals().all(), 4U);
    EXPECT_EQ(meter.slip_at(), (std::vector<std::vector<double>>{{0.1, 0.4}}));
    Case smooth = rough(), no_table = rough();
    smooth.cracks[0].contact->friction = 0.0;
    no_table.closure.profile.clear();
    for (const Case& input : {smooth, no_table}) {
        EXPECT_EQ(ClosureMeter(input.closure, {300.0}, input.cracks, {500.0}).signals().slip, 0U);
        EXPECT_TRUE(ClosureMeter(input.closure, {300.0}, input.cracks, {500.0}).slip_at().empty());
    }
}

TEST(ClosureMeter, WhatHasSlidCountsUntilTheLoadTurns) {
    const ClosureMeter meter(rough().closure, {300.0}, rough().cracks, {500.0});
    std::vector<double> now = meter.signal(with_slip({0, 1}), {});
    EXPECT_EQ(closed(now), (std::vector<bool>{1, 1, 0, 1}));
    now = meter.signal(with_slip({0, 0}), now);
    EXPECT_EQ(closed(now), (std::vector<bool>{1, 1, 0, 1}));
    EXPECT_EQ(closed(meter.signal(with_slip({1, 0}), now)), (std::vector<bool>{1, 1, 1, 1}));
    meter.forget_slip(now);
    EXPECT_EQ(closed(now), (std::vector<bool>{1, 1, 0, 0}));
}

// Slip that runs from the mouth towards the tip and halts on its way: found once per distance, whichever way
// the load goes.
TEST(ClosureMeter, FindsWhereSlipComesToItsDistances) {
    const ClosureMeter meter(rough().closure, {300.0}, rough().cracks, {500.0});
    const auto slides_in = [](const std::array<double, 2>& first, const std::array<double, 2>& second) {
        return [=](double target) {
            const auto slides = [&](const std::array<double, 2>& range) {
                return static_cast<int>(target > range[0] && target < range[1]);
            };
            return ClosureMeter::Trial{with_slip({slides(first), slides(second)}), target};
        };
    };
    const std::vector<double> locked{1.0, 1.0, -1.0, -1.0}, slid{1.0, 1.0, 1.0, 1.0};
    const auto changes =
        meter.locate({30.0, 30.0, locked}, {40.0, 40.0, slid}, {0.1, slides_in({37.3, 50.0}, {32.0, 36.0})});
    ASSERT_EQ(changes.size(), 2U);
    EXPECT_EQ(changes[0].signal, 3);
    EXPECT_NEAR(changes[0].load_factor, 32.0, 0.1);
    EXPECT_EQ(changes[1].signal, 2);
    EXPECT_NEAR(changes[1].load_factor, 37.3, 0.1);
    EXPECT_TRUE(changes[0].closes && changes[1].closes);
    EXPECT_STREQ(meter.what_a_tip_does(changes[0]), "slides");
    EXPECT_STREQ(meter.what_a_tip_does({.tip = 0, .signal = 1, .closes = false, .load_factor = 0.0}), "opens");
    const auto back =
        meter.locate({40.0, 40.0, locked}, {30.0, 30.0, slid}, {0.1, slides_in({0.0, 32.7}, {34.0, 38.0})});
    ASSERT_EQ(back.size(), 2U);
    EXPECT_NEAR(back[0].load_factor, 38.0, 0.1);
    EXPECT_NEAR(back[1].load_factor, 32.7, 0.1);
}

// At either end of the increment they do not slide: before, they stick, and behind, they are apart.
TEST(ClosureMeter, FindsSlipOfFacesThatPartInTheSameIncrement) {
    const ClosureMeter meter(rough().closure, {300.0}, rough().cracks, {500.0});
    const auto state = [](double target) {
        const double press = 37.3 - target;
        NewtonReport report = with_slip({static_cast<int>(target > 34.0 && press > 0.0), 0});
        report.iterations.back().residual.faces = {{press, press - 20.0}};
        return ClosureMeter::Trial{report, target};
    };
    const auto station = [&](double target) {
        return ClosureStation{target, target, meter.signal(state(target).report, {})};
    };
    const auto parting = meter.locate(station(30.0), station(40.0), {0.1, state});
    ASSERT_EQ(parting.size(), 2U);
    EXPECT_EQ(parting[0].signal, 2);
    EXPECT_NEAR(parting[0].load_factor, 34.0, 0.1);
    EXPECT_EQ(parting[1].signal, 0);
    EXPECT_NEAR(parting[1].load_factor, 37.3, 0.1);
    const auto meeting = meter.locate(station(40.0), station(30.0), {0.1, state});
    ASSERT_EQ(meeting.size(), 2U);
    for (const OpeningChange& change : meeting) EXPECT_NEAR(change.load_factor, 37.3, 0.1);
}

// Three contacts that part one after the other, each after it has slid, and a fourth that slides to the end: the first
// slip counts, though neither the end of the increment nor what is tried for the last one shows it.
TEST(ClosureMeter, FindsTheFirstSlipOfFacesThatPartOneAfterTheOther) {
    const ClosureMeter meter(rough().closure, {300.0}, rough().cracks, {500.0});
    const auto state = [](double target) {
        std::vector<coupling::NearestContact> nearest(2);
        for (int k = 3; k >= 0; --k) {
            const double parts = 32.0 + 2.5 * k, pressure = parts - target;
            if (pressure <= 0.0) continue;
            nearest[0] = {.behind = 0.2 + 0.3 * k, .pressure = pressure, .excess = 0.4 - pressure, .closed = 4 - k};
            nearest[1] = nearest[0];
        }
        return ClosureMeter::Trial{with_nearest(nearest), target};
    };
    const auto station = [&](double target) {
        const NewtonReport report = state(target).report;
        return ClosureStation{target, target, meter.signal(report, {}), meter.nearest(report)};
    };
    for (const double end : {33.0, 36.0, 39.3, 45.0}) {
        EXPECT_TRUE(meter.may_hide_slip(station(30.0), station(end)) || station(end).signal[2] > 0.0);
        int trials = 0;
        const auto changes = meter.locate(station(30.0), station(end), {0.05, [&](double target) {
                                                                            ++trials;
                                                                            return state(target);
                                                                        }});
        ASSERT_EQ(changes.size(), 2U);
        for (const OpeningChange& change : changes) EXPECT_NEAR(change.load_factor, 31.6, 0.05);
        EXPECT_LT(trials, 25);
    }
}

// Where the nearest contact parts on the way it may have slid before that.
TEST(ClosureMeter, GivesNoLoadOfSlipWhereNoTrialTellsWhetherItHides) {
    const ClosureMeter meter(rough().closure, {300.0}, rough().cracks, {500.0});
    const auto station = [&](double target, double behind) {
        const coupling::NearestContact nearest{.behind = behind, .pressure = 9.0, .excess = -2.0, .closed = 2};
        const NewtonReport report = with_nearest({nearest, {}});
        return ClosureStation{target, target, meter.signal(report, {}), meter.nearest(report)};
    };
    const auto fails = [](double) { return ClosureMeter::Trial{}; };
    const auto changes = meter.locate(station(30.0, 0.2), station(40.0, 0.5), {0.1, fails});
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_EQ(changes[0].signal, 2);
    EXPECT_TRUE(std::isnan(changes[0].load_factor));
    EXPECT_STREQ(meter.what_a_tip_does(changes[0]), "slides");
    EXPECT_TRUE(meter.locate(station(30.0, 0.2), station(40.0, 0.2), {0.1, fails}).empty());
    // Where contact farther off opens meanwhile a trial comes to equilibrium, and tells no more of the slip.
    ClosureStation before = station(30.0, 0.2), after = station(40.0, 0.5);
    after.signal[1] = -1.0;
    const auto later = [&](double target) {
        if (target < 39.5) return ClosureMeter::Trial{};
        NewtonReport report = with_nearest({{.behind = 0.2, .pressure = 9.0, .excess = -2.0, .closed = 2}, {}});
        report.iterations.back().residual.faces = {{1.0, 40.0 - target - 0.1}};
        return ClosureMeter::Trial{report, target};
    };
    const std::vector<ExpectedCrossing> expected{{}, {.target = 39.8}, {}, {}};
    for (const OpeningChange& change : meter.locate(before, after, {0.1, later, expected}))
        EXPECT_EQ(std::isnan(change.load_factor), change.signal == 2) << change.signal;
}

}  // namespace
}  // namespace stria::coarse
