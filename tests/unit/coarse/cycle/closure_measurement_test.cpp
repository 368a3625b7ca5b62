// What is remembered of signals of closure from one increment to the next.
#include "coarse/cycle/closure_measurement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stria::coarse {
namespace {

/// Signals of one tip, contact behind it and tension ahead of it, committed one increment after the other.
class ClosureMeasurementTest : public ::testing::Test {
protected:
    ClosureMeasurementTest() : measurement(meter(1)) { step.cycle = 1; }

    static ClosureMeter meter(std::size_t tips) {
        Case input;
        input.closure.distance = 0.2;
        input.closure.tension = true;
        return {input.closure, std::vector(tips, 300.0), input.cracks, std::vector(tips, 500.0)};
    }

    static NewtonReport state(double contact, double force) {
        NewtonReport report{.converged = true, .iterations = {{}}, .lost = {}, .failure = {}};
        report.iterations.back().residual.faces = {{contact}};
        report.iterations.back().residual.force_ahead = {force};
        return report;
    }
    [[nodiscard]] bool changes(double contact, double force) const {
        return measurement.has_changed(step, state(contact, force));
    }
    std::vector<bool> commit(double contact, double force) {
        std::vector<bool> closed;
        for (const double signal : measurement.commit(step, state(contact, force), {}, 1.0))
            closed.push_back(is_closed(signal));
        return closed;
    }

    ClosureMeasurement measurement;
    LoadStep step;
};

// Elastic faces press, or gape, in proportion to the load: at a load of zero they touch and bear nothing, and of what
// is left rounding makes any sign. So it is with the force ahead of the tip.
TEST_F(ClosureMeasurementTest, AtNoLoadNothingIsLostOrMade) {
    for (const double sign : {1.0, -1.0}) {
        commit(sign * 40.0, sign * 300.0);
        const std::vector<bool> loaded = commit(sign * 5.0, sign * 40.0);
        EXPECT_EQ(loaded, (std::vector<bool>{sign > 0.0, sign < 0.0}));
        for (const double left : {1e-11, -1e-11, 0.0}) EXPECT_FALSE(changes(left, left)) << left;
        for (const double left : {1e-11, -1e-11, 0.0, -1e-13}) EXPECT_EQ(commit(left, left), loaded) << left;
        EXPECT_FALSE(changes(sign * 5.0, sign * 40.0));
    }
}

TEST_F(ClosureMeasurementTest, WhatIsMoreThanRoundingIsLostOrMade) {
    commit(40.0, 300.0);
    EXPECT_TRUE(changes(-1e-3, 300.0));
    EXPECT_TRUE(changes(40.0, -1e-2));
    EXPECT_EQ(commit(-1e-3, -1e-2), (std::vector<bool>{false, true}));
    EXPECT_TRUE(changes(1e-3, -1e-2));
}

LegEnds leg(double from, double to, double from_case = 0.0, double to_case = 0.0) {
    return {.from = {from, Eigen::VectorXd::Constant(1, from_case)},
            .to = {to, Eigen::VectorXd::Constant(1, to_case)},
            .course = to - from};
}

TEST_F(ClosureMeasurementTest, ALegClosesWhatItLowersTheKOf) {
    step.target.value = 20.0;
    measurement.commit(step, state(40.0, 300.0),
                       {{.tip = 0, .signal = 0, .closes = true, .load_factor = 8.0, .target = 8.0}}, 1.0);
    const TipResult with{.K_I = 10.0}, against{.K_I = -10.0}, shear{.K_I = -0.05, .K_II = 10.0};
    const LegOutlook down = measurement.outlook(leg(30.0, 0.0), {with}),
                     up = measurement.outlook(leg(0.0, 30.0), {with});
    EXPECT_EQ(down.met, std::vector{8.0});
    EXPECT_TRUE(up.met.empty());
    EXPECT_EQ(measurement.outlook(leg(0.0, 30.0), {against}).met, std::vector{8.0});
    EXPECT_EQ(measurement.outlook(leg(30.0, 0.0), {shear}).met, std::vector{8.0});
    const auto senses = [&](const std::vector<TipResult>& tips) {
        const SensesOfK all = ClosureMeasurement(meter(tips.size())).outlook(leg(0.0, 30.0), tips).senses;
        return std::pair(all.with_load, all.against_load);
    };
    EXPECT_EQ(senses({with}), std::pair(true, false));
    EXPECT_EQ(senses({against}), std::pair(false, true));
    EXPECT_EQ(senses({with, against}), std::pair(true, true));
    EXPECT_EQ(senses({shear}), std::pair(true, false));
}

// Under a dead load K is zero where [load] is not.
TEST_F(ClosureMeasurementTest, ALegPressesFacesWhereKIsBelowZero) {
    const TipResult tip{.K_I = 10.0, .K_I_of_cases = {10.0}}, against{.K_I = -10.0, .K_I_of_cases = {10.0}};
    const auto presses = [&](const LegEnds& ends, const TipResult& one) {
        return measurement.outlook(ends, {one}).presses;
    };
    EXPECT_FALSE(presses(leg(30.0, 0.0), tip));
    EXPECT_TRUE(presses(leg(30.0, -1.0), tip));
    EXPECT_TRUE(presses(leg(-1.0, 30.0), tip));
    EXPECT_FALSE(presses(leg(20.0, -10.0, 10.0, 10.0), tip));
    EXPECT_TRUE(presses(leg(20.0, -11.0, 10.0, 10.0), tip));
    EXPECT_TRUE(presses(leg(30.0, 5.0, -10.0, -10.0), tip));
    EXPECT_TRUE(presses(leg(30.0, 5.0), against));
    EXPECT_FALSE(presses(leg(-30.0, -5.0), against));
    const TipResult closed{.K_I = 10.0, .K_initial = -50.0}, opened{.K_I = 10.0, .K_initial = 50.0};
    EXPECT_FALSE(presses(leg(30.0, 6.0), closed));
    EXPECT_TRUE(presses(leg(30.0, 4.0), closed));
    EXPECT_FALSE(presses(leg(30.0, -4.0), opened));
}

// A signal goes on from where it stood a cycle ago: what is expected is told in units of the history, and rates with
// it.
TEST_F(ClosureMeasurementTest, RemembersWhereASignalCameAndWentAndHowFast) {
    const double unit = 2.0;
    step.target.value = 20.0;
    measurement.commit(step, state(40.0, 300.0), {}, unit);
    EXPECT_TRUE(std::isnan(measurement.memory().opened.loads.at(0)));
    const OpeningChange closes{
        .tip = 0, .signal = 0, .closes = true, .load_factor = 8.0, .target = 8.0, .rate = {3.0, std::nan("")}},
        opens{.tip = 0, .signal = 1, .closes = false, .load_factor = 5.0, .target = 5.0, .rate = {-1.0, 7.0}};
    measurement.commit(step, state(40.0, 300.0), {closes, opens}, unit);
    const ClosureMemory& memory = measurement.memory();
    const auto& [closing_loads, closing_rates] = memory.closed;
    const auto& [opening_loads, opening_rates] = memory.opened;
    EXPECT_EQ(closing_loads.at(0), 4.0);
    EXPECT_EQ(opening_loads.at(3), 2.5);
    EXPECT_TRUE(std::isnan(opening_loads.at(0)) && std::isnan(closing_loads.at(3)));
    EXPECT_EQ(closing_rates.at(0), 6.0);
    EXPECT_TRUE(std::isnan(closing_rates.at(1)));
    EXPECT_EQ(opening_rates.at(2), -2.0);
    EXPECT_EQ(opening_rates.at(3), 14.0);
    // A change whose load nobody found leaves what is known, and so does a rate.
    OpeningChange unknown = closes;
    unknown.load_factor = std::nan("");
    unknown.target = 30.0;
    OpeningChange slower = opens;
    slower.rate = {std::nan(""), 1.0};
    measurement.commit(step, state(40.0, 300.0), {unknown, slower}, unit);
    EXPECT_EQ(closing_loads.at(0), 4.0);
    EXPECT_EQ(closing_rates.at(0), 6.0);
    EXPECT_EQ(opening_rates.at(2), -2.0);
    EXPECT_EQ(opening_rates.at(3), 2.0);
    EXPECT_EQ(std::vector(&opening_loads[3], &opening_loads[5]), (std::vector{2.5, 2.5})) << "of two cycles";
}

// Faces that closed at 8, 10 and 11 are looked for, and met, at 11.5. By its rate one trial there knows.
TEST_F(ClosureMeasurementTest, LooksWhereTheLoadsOfTheCyclesBeforeLead) {
    for (const double load : {8.0, 10.0, 11.0})
        measurement.commit(
            step, state(-30.0, 300.0),
            {{.tip = 0, .signal = 0, .closes = true, .load_factor = load, .target = load, .rate = {-2.0, NAN}}}, 1.0);
    EXPECT_EQ(measurement.outlook(leg(30.0, 0.0), {TipResult{.K_I = 10.0}}).met, std::vector{11.5});
    std::vector<double> trials;
    const auto solve = [&](const LoadStep& trial) {
        trials.push_back(trial.target.value);
        return ClosureMeter::Trial{state(2.0 * (11.495 - trial.target.value), 300.0), trial.target.value};
    };
    const std::vector<OpeningChange> found = measurement.changes(
        step, state(20.0, 300.0), {{{.value = 20.0}, 20.0}, {{.value = 0.0}, 0.0}, 1.0, 1.0}, solve);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(trials, std::vector{11.5});
    EXPECT_NEAR(found[0].target, 11.495, 1e-12);
}

TEST_F(ClosureMeasurementTest, RemembersTheLargestOfEachSignal) {
    commit(40.0, 300.0);
    commit(-70.0, -20.0);
    commit(10.0, 100.0);
    ASSERT_EQ(measurement.memory().largest.size(), 2U);
    const std::vector<double> largest = measurement.memory().largest;
    EXPECT_EQ(std::abs(largest[0]), 70.0);
    EXPECT_EQ(std::abs(largest[1]), 300.0);
}

// Trials lie between the ends, load cases at the same share of their way as [load]; one near the last trial that came
// to equilibrium goes on from there, others from a share of the attempt.
TEST_F(ClosureMeasurementTest, LooksForAChangeBetweenTheEnds) {
    commit(-30.0, 300.0);
    const ClosureMeasurement::End from{{.value = 10.0, .cases = Eigen::VectorXd::Constant(1, 4.0)}, 10.0},
        to{{.value = 30.0, .cases = Eigen::VectorXd::Constant(1, 8.0)}, 30.0};
    std::vector<LoadStep> trials;
    const auto contact_at = [](double load) { return 30.0 * (load - 17.0) / (load > 17.0 ? 13.0 : 7.0); };
    const auto solve = [&](const LoadStep& trial) {
        trials.push_back(trial);
        return ClosureMeter::Trial{state(contact_at(trial.target.value), 300.0), trial.target.value};
    };
    const std::vector<OpeningChange> found = measurement.changes(step, state(30.0, 300.0), {from, to, 0.5, 1.0}, solve);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].closes);
    EXPECT_EQ(found[0].signal, 0);
    EXPECT_NEAR(found[0].target, 17.0, 0.002 / 0.5 * 20.0);
    ASSERT_GT(trials.size(), 1U);
    double share_before = NAN;
    for (const LoadStep& trial : trials) {
        const double share = (trial.target.value - 10.0) / 20.0;
        EXPECT_NEAR(trial.target.cases[0], 4.0 + 4.0 * share, 1e-12);
        const bool near = std::abs(share - share_before) < 0.2;
        EXPECT_EQ(trial.predictor.goes_on, near);
        EXPECT_NEAR(trial.predictor.factor, near ? share - share_before : share, 1e-12);
        EXPECT_EQ(trial.predictor.back, 0);
        share_before = share;
    }
}

}  // namespace
}  // namespace stria::coarse
