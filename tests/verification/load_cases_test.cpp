// Loads with a history of their own: a dead load under cycles, tension and shear out of phase.
#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <iostream>

#include "tests/support/load_cases.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

Case small_plate() {
    return sent_case({mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=12", "solver.tolerance=1e-12"});
}

/// The ends of the plate, pulled by a load case too.
void pull_in_case(Case& input, const LoadCaseSection& load_case) {
    input.load_cases.push_back(load_case);
    for (std::size_t k : {0U, 1U}) {
        BoundarySection pulled = input.boundaries[k];
        pulled.load_case = load_case.name;
        input.boundaries.push_back(pulled);
    }
}

void expect_same_cycles(const std::vector<coarse::CycleResult>& a, const std::vector<coarse::CycleResult>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_NEAR(a[k].K_max, b[k].K_max, 1e-9 * b[k].K_max);
        EXPECT_NEAR(a[k].K_min, b[k].K_min, 1e-9 * b[k].K_max);
        EXPECT_NEAR(a[k].opening.K_op, b[k].opening.K_op, 0.002 * b[k].K_max);  // how well it is located
        EXPECT_NEAR(a[k].opening.K_cl, b[k].opening.K_cl, 0.002 * b[k].K_max);
        EXPECT_NEAR(a[k].J_max, b[k].J_max, 1e-9 * b[k].J_max);
        EXPECT_NEAR(a[k].forward, b[k].forward, 1e-9);
        EXPECT_NEAR(a[k].cyclic, b[k].cyclic, 1e-9);
    }
}

/// Once it is on, a dead force has its share in the work of an increment: that of its factor in the mean of all
/// factors. What trapezoids lack where faces part is of loads that change.
void expect_its_share(const RunHistory& with_dead, std::size_t k, double dead) {
    const coarse::Increment &now = with_dead.increments[k], &before = with_dead.increments[k - 1];
    if (before.step.target.cases[0] != dead) return;
    const double mean = dead + 0.5 * (now.load_factor + before.load_factor);
    EXPECT_NEAR((now.work.by_cases[0] - before.work.by_cases[0]) * mean,
                (now.work.external - before.work.external - now.zone.energy.contact) * dead,
                1e-9 * now.work.external * dead)
        << k;
}

/// Increment by increment. `dead`: the load factor that the one has as a dead load.
void expect_shifted(const RunHistory& with_dead, const RunHistory& whole, double dead) {
    ASSERT_EQ(with_dead.increments.size(), whole.increments.size());
    for (std::size_t k = 0; k < whole.increments.size(); ++k) {
        const coarse::Increment &a = with_dead.increments[k], &b = whole.increments[k];
        const coarse::TipResult &tip = a.tips[0], &expected = b.tips[0];
        EXPECT_NEAR(a.load_factor + dead * a.step.target.cases[0] / dead, b.load_factor, 1e-12 * 50.0);
        EXPECT_NEAR(tip.K_I, expected.K_I, 1e-9 * 800.0) << k;
        EXPECT_NEAR(tip.J, expected.J, 1e-9 * 3.0) << k;
        EXPECT_NEAR(tip.CMOD, expected.CMOD, 1e-9 * 0.05) << k;
        EXPECT_NEAR(tip.contact_length, expected.contact_length, 1e-9) << k;
        EXPECT_NEAR(tip.plastic_zone, expected.plastic_zone, 1e-9) << k;
        EXPECT_NEAR(a.K_at_end(0), b.K_at_end(0), 1e-9 * 800.0) << k;
        EXPECT_NEAR(a.machine.displacement, b.machine.displacement, 1e-9 * 0.1) << k;
        EXPECT_NEAR(a.work.external, b.work.external, 1e-9 * b.work.stored) << k;
        EXPECT_NEAR(a.work.stored, b.work.stored, 1e-9 * b.work.stored) << k;
        EXPECT_NEAR(a.work.dissipated, b.work.dissipated, 1e-9 * b.work.stored) << k;
    }
}

// The way of the one load has the dead load as a stop: a block without cycles.
TEST(LoadCases, ADeadLoadAndCyclesAreTheOneLoadShifted) {
    Case whole = small_plate(), with_dead = small_plate();
    whole.load.blocks = {{.cycles = 0, .max = 20.0}, {.cycles = 2, .max = 50.0, .min = -50.0}};
    with_dead.load.blocks = {{.cycles = 2, .max = 30.0, .min = -70.0}};
    pull_in_case(with_dead, dead_load("dead", 20.0));
    const RunHistory expected = run_direct(whole), found = run_direct(with_dead);
    expect_shifted(found, expected, 20.0);
    for (std::size_t k = 0; k < found.increments.size(); ++k)
        expect_same_cycles(found.increments[k].cycles, expected.increments[k].cycles);
    for (std::size_t k = 1; k < found.increments.size(); ++k) expect_its_share(found, k, 20.0);
    EXPECT_GT(expected.increments.back().cycles[0].opening.K_op, expected.increments.back().cycles[0].K_min);
}

// The same by imposed displacements: of a dead load and of the cycles.
TEST(LoadCases, DeadDisplacementsAddToThoseOfTheCycles) {
    const auto moved = [](Case input) {
        for (std::size_t k : {0U, 1U}) {
            input.boundaries[k].traction.reset();
            input.boundaries[k].displacement[1] = k == 0 ? 1e-3 : -1e-3;
        }
        return input;
    };
    Case whole = moved(small_plate()), with_dead = moved(small_plate());
    whole.load.blocks = {{.cycles = 0, .max = 8.0}, {.cycles = 1, .max = 20.0, .min = -20.0}};
    with_dead.load.blocks = {{.cycles = 1, .max = 12.0, .min = -28.0}};
    pull_in_case(with_dead, dead_load("dead", 8.0));
    const RunHistory expected = run_direct(whole), found = run_direct(with_dead);
    expect_shifted(found, expected, 8.0);
    for (std::size_t k = 0; k < found.increments.size(); ++k)
        EXPECT_NEAR(found.increments[k].machine.force, expected.increments[k].machine.force, 1e-9 * 3000.0);
}

// Where the displacement is controlled the load factor is found beside the dead load.
TEST(LoadCases, ADeadLoadStaysUnderDisplacementControl) {
    Case input = small_plate(), bare = small_plate();
    for (Case* one : {&input, &bare}) {
        one->load.control = Control::Displacement;
        one->load.blocks = {{.cycles = 1, .max = 0.04, .min = -0.02}};
    }
    pull_in_case(input, dead_load("dead", 10.0));
    const RunHistory with = run_direct(input), without = run_direct(bare);
    EXPECT_EQ(with.increments.size(), without.increments.size() + 6);
    const coarse::Increment &last = with.increments.back(), &other = without.increments.back();
    EXPECT_NEAR(last.machine.displacement, 0.04, 1e-12);
    EXPECT_NEAR(last.load_factor + 10.0, other.load_factor, 1e-4 * other.load_factor);  // another way to it
    EXPECT_EQ(with.increments[5].load_factor, 0.0);
    EXPECT_GT(with.increments[5].machine.displacement, 0.0);  // the machine lets it move
    for (const coarse::Increment& increment : with.increments)
        EXPECT_LT(std::abs(increment.work.error()), 0.02 * other.work.stored);
}

// An initial stress comes to equilibrium before any load, also where a load case acts on the zone's own nodes.
TEST(LoadCases, DoNotActWhileAnInitialStressComesToEquilibrium) {
    Case bare = small_plate();
    bare.load.blocks = {{.cycles = 0, .max = 1.0}};
    const double width = bare.mesh.width;
    bare.initial_stress.emplace();
    bare.initial_stress->sigma_y = StressProfile{{0.0, 0.5 * width, width}, {30.0, -30.0, 30.0}};
    Case input = bare;
    input.load_cases = {dead_load("shear", 20.0)};
    for (const auto& [on, traction] : {std::pair("top", Vec2(1.0, 0.0)), std::pair("bottom", Vec2(-1.0, 0.0)),
                                       std::pair("right", Vec2(0.0, 1.0)), std::pair("left", Vec2(0.0, -1.0))})
        input.boundaries.push_back(pulled_in_case("shear", on, traction));
    const RunHistory found = run_direct(input), expected = run_direct(bare);
    const coarse::TipResult &settled = found.increments[0].tips[0], &without = expected.increments[0].tips[0];
    EXPECT_NEAR(settled.K_I, without.K_I, 1e-9 * without.K_I);
    EXPECT_NEAR(settled.K_II, without.K_II, 1e-9 * without.K_I);
}

// Where a load lags K goes on to rise as a cycle ends. Its largest is that of the curve, whatever the increments, and
// what an overload lifts it to counts in no cycle behind it.
TEST(LoadCases, TheLargestKOfACycleIsThatOfTheCurve) {
    double unit_K = 0.0;
    const auto cycles_with = [&](int steps) {
        Case input = specimen("plate", 40.0, {{0.0, 20.3}, {12.0, 20.3}});
        input.mesh.width = 40.0;
        input.mesh.size = 2.0;
        input.load = {.steps = steps, .blocks = {{2, 60.0, 0.0}, {1, 120.0, 0.0}, {3, 60.0, 0.0}}};
        input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
        pull_in_case(input, lagging_load("late", 1.0, 90.0));
        unit_K = run_direct(input).nominal[0].K_I;
        return run_cycles(input);
    };
    const std::vector<coarse::CycleResult> few = cycles_with(12), many = cycles_with(96);
    ASSERT_EQ(few.size(), 6);
    for (std::size_t k = 0; k < few.size(); ++k) {
        EXPECT_NEAR(few[k].K_max, many[k].K_max, 2e-4 * many[k].K_max) << "cycle " << k + 1;
        // Those of the overload and of the cycle behind it are told at their ends, below the peak that is to come: 1.5
        // of 1.71, squared. The cycle before has risen less high, or higher.
        const double J = many[k].K_max * many[k].K_max * many[0].J_max / (many[0].K_max * many[0].K_max);
        EXPECT_NEAR(many[k].J_max, (k == 1 || k == 2 ? 0.77 : 1.0) * J, 0.02 * J) << "cycle " << k + 1;
    }
    // (1 + cos x) / 2 and (1 + sin x) / 2 add up to 1 + sqrt(1/2) at 45 degrees, and to 1.5 at the end of a cycle.
    const double at_end = many[5].K_max * 1.5 / (1.0 + std::sqrt(0.5));
    EXPECT_NEAR(at_end, 1.5 * 60.0 * unit_K, 1e-3 * at_end);
    for (const std::size_t k : {0U, 2U, 3U, 4U, 5U}) EXPECT_NEAR(few[k].K_max, many[5].K_max, 1e-3 * at_end) << k + 1;
    EXPECT_GT(few[1].K_max, 1.5 * few[0].K_max);
}

/// A central crack under tension and, behind it by a quarter of a cycle, shear.
Case twisted(double size, int cycles) {
    Case input = specimen("plate", 40.0, {{16.0, 20.3}, {24.0, 20.3}});
    input.mesh.width = 40.0;
    input.mesh.size = 4.0;
    input.mesh.grading = {{.at = {{20.0, 20.3}}, .size = size, .outer_size = size, .radius = 5.0, .growth = 0.4}};
    input.load = {.steps = 16, .grading = 1.0, .blocks = {{.cycles = cycles, .max = 60.0, .min = -60.0}}};
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load_cases = {lagging_load("shear", 0.5, 90.0)};
    for (const auto& [on, traction] : {std::pair("top", Vec2(1.0, 0.0)), std::pair("bottom", Vec2(-1.0, 0.0)),
                                       std::pair("right", Vec2(0.0, 1.0)), std::pair("left", Vec2(0.0, -1.0))})
        input.boundaries.push_back(pulled_in_case("shear", on, traction));
    return input;
}

// Without contact: each K follows its own load, and the two go round an ellipse.
TEST(LoadCases, TensionAndShearOutOfPhaseGoRoundAnEllipse) {
    const RunHistory run = run_direct(twisted(0.5, 2));
    const coarse::TipResult& unit = run.nominal[0];
    EXPECT_NEAR(unit.K_II_of_cases[0], unit.K_I, 0.04 * unit.K_I);  // but for the width
    EXPECT_NEAR(unit.K_I_of_cases[0], 0.0, 1e-3 * unit.K_I);
    for (const coarse::Increment& increment : run.increments) {
        const double shear = increment.step.target.cases[0];
        const double K_I = increment.load_factor * unit.K_I + shear * unit.K_I_of_cases[0];
        const double K_II = increment.load_factor * unit.K_II + shear * unit.K_II_of_cases[0];
        EXPECT_NEAR(increment.tips[0].K_I, K_I, 1e-9 * 60.0 * unit.K_I);
        EXPECT_NEAR(increment.tips[0].K_II, K_II, 1e-9 * 60.0 * unit.K_I);
        EXPECT_NEAR(increment.work.error(), 0.0, 0.05 * increment.work.stored + 1e-6);
        if (increment.step.cycle == 0 || increment.number < 16) continue;
        EXPECT_NEAR(std::hypot(increment.load_factor / 60.0, shear / 30.0), 1.0, 1e-9);
    }
}

TEST(LoadCases, TwentyCyclesOutOfPhaseLoseNoIncrementLong) {
    Case input = twisted(0.25, 20);
    input.material.yield_stress = 200.0;
    input.material.kinematic = {{.C = 20e3, .gamma = 100.0}};
    input.cracks[0].contact = ContactSection{0.3};
    const RunHistory run = run_direct(input);
    EXPECT_EQ(run.cuts, 0);
    EXPECT_EQ(run.increments.back().step.cycle, 20);
    int iterations = 0;
    bool flows = false, slides = false;
    for (const coarse::Increment& increment : run.increments) {
        iterations += increment.newton.count();
        flows = flows || increment.tips[0].plastic_zone > 0.0;
        slides = slides || increment.work.by_friction > 0.0;
    }
    EXPECT_TRUE(flows && slides);
    const auto& last = run.increments.back();
    std::cout << fmt::format(
        "{} increments, {:.2f} iterations each; friction {:.4g} N of {:.4g} N dissipated; error of "
        "the balance {:.2g} N\n",
        run.increments.size(), 1.0 * iterations / static_cast<double>(run.increments.size()), last.work.by_friction,
        last.work.dissipated, last.work.error());
    EXPECT_LT(std::abs(last.work.error()), 0.05 * last.work.external);
}

}  // namespace
}  // namespace stria::test
