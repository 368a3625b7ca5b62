// Controlled displacements of a boundary that a dead load or an initial stress has moved before.
#include <gtest/gtest.h>

#include <algorithm>

#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "tests/support/controlled_plates.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

/// Without flow and contact: no zone.
Case elastic(Case input) {
    input.material.yield_stress.reset();
    input.cracks[0].contact.reset();
    input.fine.radius.reset();
    return input;
}

RunHistory run_elastic(const Case& plastic) {
    const Case input = elastic(plastic);
    coarse::CondensedFactory factory(nullptr, input);
    return run_analysis(input, factory);
}

// The way to the first maximum began at a displacement of zero, to which nobody had asked it back.
TEST(ElasticDisplacementControl, GoesOnFromWhereADeadLoadHasMovedTheBoundary) {
    const RunHistory run = run_elastic(beside_a_dead_load({.cycles = 1, .max = 0.16, .min = 0.02}));
    expect_straight_on(run, 0.16);
    EXPECT_NEAR(run.increments[3 * half_cycle - 1].machine.displacement, 0.02, 1e-12);
    EXPECT_NEAR(run.increments[4 * half_cycle - 1].machine.displacement, 0.16, 1e-12);
}

// A first displacement that the dead load has passed is gone back to; one of zero is no exception.
TEST(ElasticDisplacementControl, GoesBackFromADeadLoadWhereThatIsAsked) {
    for (const double first : {0.02, 0.0}) {
        const RunHistory run = run_elastic(beside_a_dead_load({.cycles = 1, .max = first, .min = -0.02}));
        ASSERT_EQ(run.increments.size(), 4 * half_cycle);
        const Followed &maximum = run.increments[2 * half_cycle - 1], &minimum = run.increments[3 * half_cycle - 1];
        EXPECT_NEAR(maximum.machine.displacement, first, 1e-12);
        EXPECT_TRUE(maximum.step.at_maximum);
        EXPECT_FALSE(maximum.step.reversal) << "it goes on in the same direction";
        EXPECT_EQ(maximum.step.cycle, 0);
        EXPECT_NEAR(minimum.machine.displacement, -0.02, 1e-12);
        EXPECT_TRUE(minimum.step.reversal);
        for (std::size_t k = half_cycle; k < 3 * half_cycle; ++k)
            EXPECT_LT(run.increments[k].machine.displacement, run.increments[k - 1].machine.displacement);
    }
}

Case with_initial_stress() {
    return small_sent({"initial_stress={sigma_y={at=[0.0,25.0,50.0], stress=[200.0,-200.0,200.0]}}"});
}

// An initial stress moves it as well. Without load the boundary stands at `settled`.
TEST(ElasticDisplacementControl, GoesOnFromWhereAnInitialStressHasMovedTheBoundary) {
    Case input = with_initial_stress();
    const double settled = run_elastic(input).increments[0].machine.displacement;
    ASSERT_GT(settled, 0.0);
    input.load.control = Control::Displacement;
    input.load.blocks = {{.cycles = 0, .max = 1.5 * settled, .min = 0.0}};
    const RunHistory run = run_elastic(input);
    ASSERT_EQ(run.increments.size(), 1 + half_cycle);
    for (std::size_t k = 1; k <= half_cycle; ++k)
        EXPECT_GT(run.increments[k].load_factor, run.increments[k - 1].load_factor);
    EXPECT_NEAR(run.increments.back().machine.displacement, 1.5 * settled, 1e-12);
}

// The first maximum was passed over: the boundary went to the minimum at once, a half cycle later in the history.
TEST(ElasticDisplacementControl, GoesBackFromAnInitialStressToADisplacementOfZero) {
    Case input = with_initial_stress();
    input.load.control = Control::Displacement;
    input.load.blocks = {{.cycles = 1, .max = 0.0, .min = -0.02}};
    const RunHistory run = run_elastic(input);
    ASSERT_EQ(run.increments.size(), 1 + 3 * half_cycle);
    const double settled = run.increments[0].machine.displacement;
    ASSERT_GT(settled, 0.0);
    EXPECT_NEAR(run.increments[1].machine.displacement, 0.75 * settled, 1e-12);
    const Followed &maximum = run.increments[half_cycle], &minimum = run.increments[2 * half_cycle];
    EXPECT_NEAR(maximum.machine.displacement, 0.0, 1e-12);
    EXPECT_TRUE(maximum.step.at_maximum);
    EXPECT_FALSE(maximum.step.reversal) << "it goes on in the same direction";
    EXPECT_EQ(maximum.step.cycle, 0);
    EXPECT_NEAR(minimum.machine.displacement, -0.02, 1e-12);
    EXPECT_EQ(minimum.step.cycle, 1);
}

/// Nominal, of the increments of an elastic body.
double largest_K_reached(const RunHistory& run) {
    double largest = 0.0;
    for (const Followed& increment : run.increments)
        largest =
            std::max(largest, K_I_under(increment.nominal[0], {increment.load_factor, increment.step.target.cases}));
    return largest;
}

// The zone was that of K beyond the dead load's, as if [load] alone moved the boundary.
TEST(ElasticDisplacementControl, EquationThreeHasTheLargestKThatIsReached) {
    Case stressed = with_initial_stress();
    stressed.load.control = Control::Displacement;
    stressed.load.blocks = {{.cycles = 1, .max = 0.1, .min = -0.05}};
    Case beside_both = beside_a_dead_load({.cycles = 1, .max = 0.2, .min = 0.05});
    beside_both.initial_stress = stressed.initial_stress;
    for (const Case& input : {beside_a_dead_load({.cycles = 1, .max = 0.16, .min = 0.02}),
                              beside_a_dead_load({.cycles = 1, .max = 0.02, .min = -0.02}), stressed, beside_both}) {
        const RunHistory run = run_elastic(input);
        const coarse::UnitResponse unit = unit_response(coarse::solve_nominal(coarse::refined_scene(elastic(input))));
        const double K = coarse::largest_K(input, unit).at(0);
        EXPECT_NEAR(K, largest_K_reached(run), 1e-4 * K);
    }
}

}  // namespace
}  // namespace stria::test
