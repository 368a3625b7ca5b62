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

}  // namespace
}  // namespace stria::coarse
