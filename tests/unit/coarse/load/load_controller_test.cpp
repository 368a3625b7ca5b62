// The loads of a history: ramp, cycles, blocks, halved increments, and what each increment may extrapolate.
#include "coarse/load/load_controller.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace stria::coarse {
namespace {

LoadController controller(int steps, std::vector<LoadBlock> blocks, int max_cuts = 3, Control control = Control::Load) {
    return LoadController({.steps = steps, .grading = 1.0, .blocks = std::move(blocks), .control = control},
                          {.tolerance = 1e-8, .max_iterations = 25, .max_cuts = max_cuts});
}

/// Of a tip whose K is `unit_K` times the load.
LegOutlook outlook(const LegEnds& leg, std::vector<double> met, double unit_K = 1.0) {
    const double from = unit_K * leg.from.main, to = unit_K * leg.to.main;
    if (to > from) met.clear();
    return {.met = std::move(met),
            .presses = std::min(from, to) < 0.0,
            .senses = {.with_load = unit_K > 0.0, .against_load = unit_K < 0.0}};
}

void accept_with_meetings(LoadController& loads, const std::vector<double>& met, double unit_K = 1.0) {
    loads.accepted();
    if (const auto leg = loads.leg_that_begins({.mean = 1.0})) loads.expect(outlook(*leg, met, unit_K));
}

std::vector<LoadStep> all_steps(LoadController loads) {
    std::vector<LoadStep> steps;
    while (const auto step = loads.next()) {
        steps.push_back(*step);
        loads.accepted();
    }
    return steps;
}

std::vector<double> factors(const LoadController& loads) {
    std::vector<double> result;
    for (const LoadStep& step : all_steps(loads)) result.push_back(step.target.value);
    return result;
}

TEST(LoadController, RampsToTheMaximumThenCyclesFromItAndBack) {
    const auto loads = controller(8, {{.cycles = 1, .max = 40.0, .min = -40.0}});
    EXPECT_EQ(factors(loads), (std::vector<double>{10, 20, 30, 40, 20, 0, -20, -40, -20, 0, 20, 40}));
    const std::vector<LoadStep> steps = all_steps(loads);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        EXPECT_EQ(steps[k].cycle, k < 4 ? 0 : 1);
        EXPECT_DOUBLE_EQ(steps[k].moment, (static_cast<double>(k) - 3.0) / 8.0);  // in cycles
        EXPECT_EQ(steps[k].reversal, k % 4 == 3);
        EXPECT_EQ(steps[k].at_maximum, k == 3 || k == 11);
        EXPECT_EQ(steps[k].at_minimum, k == 7);
        EXPECT_EQ(steps[k].at_zero, k == 5 || k == 9);
        EXPECT_EQ(steps[k].ends_cycle, k == 11);
    }
}

TEST(LoadController, ACycleEndsAtTheMaximumOfTheNextOne) {
    EXPECT_EQ(factors(controller(4, {{2, 10.0, 0.0}, {1, 20.0, 10.0}, {1, 20.0, 0.0}})),
              (std::vector<double>{5, 10, 5, 0, 5, 10, 5, 0, 10, 20, 15, 10, 15, 20, 10, 0, 10, 20}));
}

TEST(LoadController, SaysWhatItsTargetsAre) {
    EXPECT_EQ(to_text(controller(4, {{1, 10.0, 0.0}}).next()->target), "load factor 5");
    const auto stretched = controller(4, {{1, 0.5, 0.0}}, 3, Control::Displacement);
    EXPECT_EQ(stretched.next()->target.control, Control::Displacement);
    EXPECT_EQ(to_text(stretched.next()->target), "displacement 0.25 mm");
}

TEST(LoadController, ReachesExtremesExactly) {  // 50 / 3 and its multiples are no doubles
    for (const LoadStep& step : all_steps(controller(14, {{.cycles = 5, .max = 50.0 / 3.0, .min = -0.1}}))) {
        EXPECT_TRUE(!step.reversal || step.target.value == 50.0 / 3.0 || step.target.value == -0.1)
            << step.target.value;
    }
}

TEST(LoadController, ExtrapolatesButNotPastAReversal) {
    const std::vector<LoadStep> steps = all_steps(controller(4, {{1, 10.0, -10.0}}));
    const std::vector<double> predictors{0, 1, 0, 1, 0, 1};
    for (std::size_t k = 0; k < steps.size(); ++k) EXPECT_EQ(steps[k].predictor, predictors[k]) << k;
    EXPECT_EQ(all_steps(controller(4, {{1, 10.0, -30.0}}))[2].predictor, 0.0);
}

TEST(LoadController, ACycleStartsFromTheIncrementsOfTheOneBefore) {
    const std::vector<LoadStep> steps = all_steps(controller(4, {{3, 10.0, 0.0}, {1, 20.0, 0.0}}));
    for (std::size_t k = 6; k < 12; ++k) EXPECT_EQ(steps[k].predictor, Predictor(1.0, 4)) << k;
    EXPECT_EQ(steps[4].predictor, Predictor());   // reloads where the ramp loaded: no twin
    EXPECT_EQ(steps[12].predictor, Predictor());  // from 0 to 10 at once: for the first time
    auto loads = controller(4, {{2, 10.0, 0.0}});
    for (int k = 0; k < 6; ++k) loads.accepted();
    loads.forget_increments();
    EXPECT_EQ(loads.next()->predictor, Predictor());
}

// Once, where a crack has grown onto other elements; twice in a row, where it has grown far.
TEST(LoadController, ForgetsIncrementsThatMisleadTwiceInARow) {
    auto loads = controller(4, {{2, 10.0, 0.0}});
    for (int k = 0; k < 6; ++k) loads.accepted();
    const auto judged = [&](std::vector<bool> misled) {
        LoadController copy = loads;
        for (const bool one : misled) copy.judge_predictor(one);
        auto again = controller(4, {{2, 10.0, 0.0}});
        again.resume(copy.position());
        EXPECT_EQ(again.next()->predictor, copy.next()->predictor);
        return copy.next()->predictor;
    };
    EXPECT_EQ(judged({true}), Predictor(1.0, 4));
    EXPECT_EQ(judged({true, false, true}), Predictor(1.0, 4));
    EXPECT_EQ(judged({true, true}), Predictor());
    EXPECT_EQ(judged({false, true, true, false}), Predictor());
    LoadController before = loads;
    before.judge_predictor(true);
    LoadController resumed = controller(4, {{2, 10.0, 0.0}});
    resumed.resume(before.position());
    resumed.judge_predictor(true);
    EXPECT_EQ(resumed.next()->predictor, Predictor()) << "a run that is gone on with knows of the first one";
}

// In units of the history, and only on the way down: what opens does so after its faces have parted.
TEST(LoadController, EndsAnIncrementWhereFacesAreExpectedToMeet) {
    LoadController loads({.blocks = {{.cycles = 2, .max = 40.0, .min = -40.0}}, .control = Control::StressIntensity},
                         SolverSection());
    loads.set_scale(0.1);
    constexpr double met = 10.0;
    std::vector<bool> ends_there(1, false);
    while (const auto step = loads.next()) {
        if (std::abs(step->target.value - 0.1 * met) < 1e-12) ends_there.back() = true;
        accept_with_meetings(loads, {std::numeric_limits<double>::quiet_NaN(), met, 50.0});
        if (step->reversal) ends_there.push_back(false);
    }
    EXPECT_EQ(ends_there, (std::vector<bool>{false, true, false, true, false, false}));  // the last one does not come
}

// A crack that has grown is loaded beyond what the history says of it: the way down is longer, and ends lie elsewhere
// on it.
TEST(LoadController, EndsAnIncrementWhereFacesOfALongerCrackMeet) {
    LoadController loads({.blocks = {{.cycles = 2, .max = 40.0, .min = 0.0}}, .control = Control::StressIntensity},
                         SolverSection());
    loads.set_scale(0.1);
    for (bool up = true; up;) {
        up = !loads.next()->at_maximum;
        loads.accepted({});
    }
    loads.set_scale(0.08);
    constexpr double met = 10.0;
    loads.expect(outlook(*loads.leg_that_begins({.mean = 1.0}), {met}));
    bool ends_there = false;
    for (auto step = loads.next(); !step->at_minimum; step = loads.next()) {
        ends_there = ends_there || std::abs(step->target.value - 0.08 * met) < 1e-12;
        loads.accepted({});
    }
    EXPECT_TRUE(ends_there);
}

// The faces of a tip that opens as the load falls meet as it rises.
TEST(LoadController, EndsAnIncrementWhereFacesMeetAsTheLoadRises) {
    LoadController loads({.blocks = {{.cycles = 2, .max = 40.0, .min = -40.0}}}, SolverSection());
    std::vector<bool> ends_there(1, false);
    while (const auto step = loads.next()) {
        if (step->target.value == -10.0) ends_there.back() = true;
        accept_with_meetings(loads, {-10.0}, -1.0);
        if (step->reversal) ends_there.push_back(false);
    }
    EXPECT_EQ(ends_there, (std::vector<bool>{false, false, true, false, true, false}));
}

TEST(LoadController, KnowsWhichLegsPressFacesTogether) {
    const auto pressing = [](double min) {
        LoadController loads({.blocks = {{.cycles = 1, .max = 40.0, .min = min}}}, SolverSection());
        std::vector<bool> presses;
        while (const auto step = loads.next()) {
            presses.push_back(loads.position().schedule.presses);
            while (!loads.next()->reversal) accept_with_meetings(loads, {10.0});
            accept_with_meetings(loads, {10.0});
        }
        return presses;
    };
    EXPECT_EQ(pressing(0.0), (std::vector<bool>{false, false, false}));
    EXPECT_EQ(pressing(-20.0), (std::vector<bool>{false, true, true}));
}

TEST(LoadController, KnowsWhereFacesMetWhenItsHistoryIsMadeLonger) {
    const auto stops = [](LoadController& loads) {
        std::vector<double> targets;
        while (const auto step = loads.next()) {
            targets.push_back(step->target.value);
            accept_with_meetings(loads, {10.0});
        }
        return targets;
    };
    const auto cycles = [](int count) {
        return LoadController({.blocks = {{.cycles = count, .max = 40.0, .min = -40.0}}}, SolverSection());
    };
    LoadController shorter = cycles(1), whole = cycles(2), longer = cycles(2);
    std::vector<double> found = stops(shorter);
    longer.resume(shorter.position());
    longer.expect(outlook(*longer.leg_that_begins({.mean = 1.0}), {10.0}));
    std::ranges::copy(stops(longer), std::back_inserter(found));
    EXPECT_EQ(found, stops(whole));
}

TEST(LoadController, FollowsTheCrackWhereKIsControlled) {
    auto loads = controller(4, {{2, 100.0, 50.0}}, 3, Control::StressIntensity);
    loads.set_scale(0.1);
    const auto go = [&](int steps) {
        std::vector<double> found;
        for (int k = 0; k < steps; ++k) {
            found.push_back(loads.next()->target.value);
            EXPECT_EQ(loads.next()->target.control, Control::Load);
            loads.accepted();
        }
        return found;
    };
    EXPECT_EQ(go(6), (std::vector<double>{5, 10, 7.5, 5, 7.5, 10}));
    loads.set_scale(0.08);  // the crack has grown, at constant load
    EXPECT_EQ(go(4), (std::vector<double>{7, 4, 6, 8}));
    EXPECT_FALSE(loads.next());
}

// Its load falls as the crack grows; in units of the history the increments are those of the cycle before.
TEST(LoadController, AtConstantKACycleStartsFromTheIncrementsOfTheOneBefore) {
    auto loads = controller(8, {{.cycles = 3, .max = 40.0, .min = 0.0}}, 3, Control::StressIntensity);
    double scale = 0.1;
    loads.set_scale(scale);
    for (int k = 0; const auto step = loads.next(); ++k) {
        const bool rises = k % 8 < 4;
        if (k >= 16 && rises) {
            EXPECT_EQ(step->predictor.back, 8) << k;
            EXPECT_NEAR(step->predictor.factor, 1.0, 1e-12) << k;
        }
        loads.accepted();
        if (step->ends_cycle) loads.set_scale(scale *= 0.8);
    }
}

TEST(LoadController, GradesTheIncrementsFromEachReversal) {
    const LoadController loads({.steps = 8, .grading = 0.5, .blocks = {{1, 2.0, -2.0}}}, {});
    const std::vector<double> found = factors(loads);
    for (std::size_t k = 0; k < 4; ++k) {
        const double way = std::sqrt(static_cast<double>(k + 1) / 4.0);
        EXPECT_DOUBLE_EQ(found[k], 2.0 * way);
        EXPECT_DOUBLE_EQ(found[4 + k], 2.0 - 4.0 * way);
    }
}

TEST(LoadController, HalvesAndGrowsAgain) {
    auto loads = controller(4, {{1, 16.0, 0.0}});
    loads.accepted();  // 8
    ASSERT_TRUE(loads.cut());
    ASSERT_TRUE(loads.cut());
    EXPECT_EQ(loads.next()->target.value, 10.0);
    EXPECT_EQ(loads.next()->predictor, 0.25);
    EXPECT_EQ(loads.next()->next_over_this, 2.0);
    EXPECT_FALSE(loads.next()->reversal);
    loads.accepted();
    EXPECT_EQ(loads.next()->target.value, 14.0);
    EXPECT_EQ(loads.next()->predictor, 2.0);
    EXPECT_EQ(loads.next()->next_over_this, 0.5);
    loads.accepted();
    EXPECT_EQ(loads.next()->target.value, 16.0);  // what is left
    EXPECT_EQ(loads.next()->predictor, 0.5);
    EXPECT_EQ(loads.next()->next_over_this, 4.0);
    EXPECT_TRUE(loads.next()->at_maximum || loads.next()->reversal);
    loads.accepted();
    EXPECT_EQ(loads.next()->target.value, 8.0);
    EXPECT_EQ(loads.next()->predictor, 0.0);
    EXPECT_EQ(loads.cuts(), 2);
}

TEST(LoadController, GivesUpAfterTheLastHalving) {
    auto loads = controller(4, {{1, 16.0, 0.0}}, 2);
    EXPECT_TRUE(loads.cut());
    EXPECT_TRUE(loads.cut());
    EXPECT_FALSE(loads.cut());
    EXPECT_EQ(loads.reached(), 0.0);
}

TEST(LoadController, ACutIncrementStillEndsExactlyAtItsTarget) {
    auto loads = controller(6, {{1, 0.3, -0.3}}, 8);
    std::vector<double> reached;
    for (int k = 0; loads.next(); ++k) {
        EXPECT_TRUE(k % 3 != 0 || loads.cut());
        if (loads.next()->reversal) reached.push_back(loads.next()->target.value);
        loads.accepted();
    }
    EXPECT_EQ(reached, (std::vector<double>{0.3, -0.3, 0.3}));
}

}  // namespace
}  // namespace stria::coarse
