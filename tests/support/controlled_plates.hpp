// A plate whose loaded boundary is moved, with or without what has moved it before.
#pragma once

#include <gtest/gtest.h>

#include "tests/support/load_cases.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {

/// 10 mm elements, 1 mm at the tip: plastic flow at the load factor 100, half of what the plate bears.
inline Case small_sent(std::vector<std::string> overrides) {
    overrides.insert(overrides.end(), {mesh_at_tip(1.0), "mesh.size=10.0", "solver.tolerance=1e-12", "load.steps=8",
                                       "load.blocks=[{max=100.0,ratio=-0.5}]"});
    return sent_case(std::move(overrides));
}

/// Pulled at both ends by 60 MPa, which moves them apart by more than a quarter of 0.16 mm and less than that.
inline Case beside_a_dead_load(const LoadBlock& block) {
    Case input = small_sent({"fine.radius=200.0"});
    input.load.control = Control::Displacement;
    input.load.blocks = {block};
    input.load_cases = {dead_load("dead", 60.0)};
    for (const double side : {1.0, -1.0})
        input.boundaries.push_back(pulled_in_case("dead", side > 0.0 ? "top" : "bottom", {0.0, side}));
    return input;
}

constexpr std::size_t half_cycle = 4;  // increments, and so many in which dead loads come on

/// On the way to the first maximum, behind dead loads.
inline void expect_straight_on(const RunHistory& run, double to) {
    ASSERT_GE(run.increments.size(), 2 * half_cycle);
    const double from = run.increments[half_cycle - 1].machine.displacement;
    for (std::size_t k = half_cycle; k < 2 * half_cycle; ++k) {
        const Followed &before = run.increments[k - 1], &now = run.increments[k];
        EXPECT_GT(now.machine.displacement, before.machine.displacement) << "increment " << k + 1;
        EXPECT_GT(now.load_factor, before.load_factor) << "increment " << k + 1;
        EXPECT_EQ(now.step.reversal, k + 1 == 2 * half_cycle);
    }
    EXPECT_NEAR(run.increments[2 * half_cycle - 1].machine.displacement, to, 1e-12);
    EXPECT_NEAR(run.increments[half_cycle].step.target.value, from + 0.25 * (to - from), 1e-12);
}

}  // namespace stria::test
