// What is remembered of signals of closure from one increment to the next.
#include "coarse/analysis/closure_measurement.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace stria::coarse {
namespace {

/// Signals of one tip, contact behind it and tension ahead of it, committed one increment after the other.
class ClosureMeasurementTest : public ::testing::Test {
protected:
    ClosureMeasurementTest() {
        Case input;
        input.closure.distance = 0.2;
        input.closure.tension = true;
        measurement.emplace(ClosureMeter(input.closure, {300.0}, input.cracks, {500.0}));
        step.cycle = 1;
    }

    static NewtonReport state(double contact, double force) {
        NewtonReport report{.converged = true, .iterations = {{}}, .lost = {}, .failure = {}};
        report.iterations.back().residual.faces = {{contact}};
        report.iterations.back().residual.force_ahead = {force};
        return report;
    }
    [[nodiscard]] bool changes(double contact, double force) const {
        return measurement->has_changed(step, state(contact, force));
    }
    std::vector<bool> commit(double contact, double force) {
        std::vector<bool> closed;
        for (const double signal : measurement->commit(step, state(contact, force), {}, 1.0))
            closed.push_back(is_closed(signal));
        return closed;
    }

    std::optional<ClosureMeasurement> measurement;
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
    return {.from = {from, Eigen::VectorXd::Constant(1, from_case)}, .to = {to, Eigen::VectorXd::Constant(1, to_case)}};
}

TEST_F(ClosureMeasurementTest, ALegClosesWhatItLowersTheKOf) {
    step.target.value = 20.0;
    measurement->commit(step, state(40.0, 300.0),
                        {{.tip = 0, .signal = 0, .closes = true, .load_factor = 8.0, .target = 8.0}}, 1.0);
    const TipResult with{.K_I = 10.0}, against{.K_I = -10.0}, shear{.K_I = -0.05, .K_II = 10.0};
    const LegOutlook down = measurement->outlook(leg(30.0, 0.0), {with}),
                     up = measurement->outlook(leg(0.0, 30.0), {with});
    EXPECT_EQ(down.met, std::vector{8.0});
    EXPECT_TRUE(up.met.empty());
    EXPECT_EQ(measurement->outlook(leg(0.0, 30.0), {against}).met, std::vector{8.0});
    EXPECT_EQ(measurement->outlook(leg(30.0, 0.0), {shear}).met, std::vector{8.0});
    const auto senses = [&](const std::vector<TipResult>& tips) {
        const SensesOfK all = measurement->outlook(leg(0.0, 30.0), tips).senses;
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
        return measurement->outlook(ends, {one}).presses;
    };
    EXPECT_FALSE(presses(leg(30.0, 0.0), tip));
    EXPECT_TRUE(presses(leg(30.0, -1.0), tip));
    EXPECT_TRUE(presses(leg(-1.0, 30.0), tip));
    EXPECT_FALSE(presses(leg(20.0, -10.0, 10.0, 10.0), tip));
    EXPECT_TRUE(presses(leg(20.0, -11.0, 10.0, 10.0), tip));
    EXPECT_TRUE(presses(leg(30.0, 5.0, -10.0, -10.0), tip));
    EXPECT_TRUE(presses(leg(30.0, 5.0), against));
    EXPECT_FALSE(presses(leg(-30.0, -5.0), against));
}

}  // namespace
}  // namespace stria::coarse
