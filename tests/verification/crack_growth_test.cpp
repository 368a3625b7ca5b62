// Cracks that grow: the state stays, equilibrium is found again, and the wake closes (docs/method.md, section 7).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iostream>
#include <numbers>
#include <optional>

#include "coarse/specimen/handbook.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

// An elastic body has no memory: after any growth K is that of the longer crack from the start.
TEST(CrackGrowth, AnElasticBodyForgetsHowTheCrackCameThere) {
    Case input = edge_crack(0.3, 3.0, End::Pulled);
    input.mesh.size = 1.0 / 21.0;
    input.load = {.steps = 2, .blocks = {{.cycles = 3, .max = 1.0, .min = 0.0}}};
    input.growth.emplace().increment = 0.031;
    const RunHistory run = run_direct(input);
    const ElasticSolution longer([&] {
        Case grown = input;
        grown.growth.reset();
        grown.cracks[0].points[1].x() += 3.0 * 0.031;
        return grown;
    }());
    const coarse::TipResult& tip = run.increments.back().tips[0];
    EXPECT_NEAR(tip.a, 0.393, 1e-12);
    EXPECT_NEAR(tip.K_I, longer.tips[0].K_I, 1e-9 * tip.K_I);
    EXPECT_NEAR(tip.CMOD, longer.tips[0].CMOD, 1e-9 * tip.CMOD);
}

// A tip on a node is held there by the mesh until it is a thousandth of an edge away.
TEST(CrackGrowth, ShortStepsLeaveANode) {
    for (const double increment : {0.0009, 0.0003}) {
        Case input = specimen("plate", 40.0, {{0.0, 20.0}, {6.0, 20.0}});
        input.mesh.width = 20.0;
        input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
        input.load = {.steps = 2, .blocks = {{.cycles = 9, .max = 60.0, .min = 0.0}}};
        input.growth = GrowthSection{.increment = increment, .direction = GrowthDirection::Straight};
        double grown = 0.0;
        for (const Followed& step : run_direct(input).increments)
            for (const coarse::CycleResult& cycle : step.cycles) grown += cycle.da;
        EXPECT_NEAR(grown, 8.0 * increment, 1e-3) << increment;
        EXPECT_GT(grown, 0.0) << increment;
    }
}

// So its faces part as soon as the load comes back, and bear none of it when it is gone.
TEST(CrackGrowth, AnElasticBodyWhoseFacesTouchForgetsItToo) {
    Case input = edge_crack(0.3, 3.0, End::Pulled);
    input.mesh.size = 1.0 / 41.0;
    input.mesh.grading = {{.at = {{0.3, 1.5}}, .size = 0.005, .outer_size = 0.005, .radius = 0.05}};
    input.cracks[0].contact = ContactSection{};
    input.load = {.steps = 4, .blocks = {{.cycles = 4, .max = 1.0, .min = 0.0}}};
    input.growth.emplace().increment = 0.005;
    const RunHistory run = run_direct(input);
    int cycles = 0;
    for (const coarse::Increment& step : run.increments) {
        if (step.load_factor == 0.0) {
            EXPECT_LT(std::abs(step.tips[0].K_I), 1e-6 * step.nominal[0].K_I);
        }
        for (const coarse::CycleResult& cycle : step.cycles) {
            ++cycles;
            EXPECT_LT(std::abs(cycle.opening.K_op), 0.002 * cycle.K_max) << "to what loads are looked for";
        }
    }
    EXPECT_EQ(cycles, 4);
}

/// An edge crack from a/W = .3 to .5 by Paris' law, or to where it breaks.
struct ParisLife {
    static constexpr double C = 1e-13, m = 3.0, stress = 80.0;
    double cycles = 0.0, end = 0.0;
    std::size_t computed = 0;

    ParisLife(OrAuto<double> increment, double element, GrowthAt at = GrowthAt::Maximum,
              std::optional<double> toughness = {}) {
        Case input = edge_crack(0.3, 4.0, End::Pulled);
        input.mesh.size = element;
        input.load = {.steps = 2, .blocks = {{.cycles = 100, .max = stress, .min = 0.0}}};
        input.growth =
            GrowthSection{.law = GrowthLaw::Paris, .increment = increment, .at = at, .C = C, .m = m, .until = 0.5};
        input.growth->toughness = toughness;
        const RunHistory run = run_direct(input);
        for (const coarse::Increment& step : run.increments)
            for (const coarse::CycleResult& cycle : step.cycles) {
                cycles += cycle.dN;
                ++computed;
            }
        end = run.increments.back().tips[0].a;
    }

    /// The handbook's K at the largest load.
    static double K_at(double a) { return stress * coarse::sent_factor(a) * std::sqrt(std::numbers::pi * a); }

    /// The integral of 1 / (C dK^m) with the handbook's K.
    static double by_handbook(double to = 0.5) {
        constexpr int parts = 2000;
        const double da = (to - 0.3) / parts;
        double life = 0.0;
        for (int k = 0; k < parts; ++k) life += da / (C * std::pow(K_at(0.3 + da * (k + 0.5)), m));
        return life;
    }
};

TEST(CrackGrowth, LivesAsLongAsParisLawSays) {
    const double handbook = ParisLife::by_handbook();
    // Chosen increments are no smaller than an element.
    // At the first minimum no cycle has told a rate yet.
    for (const auto& life :
         {ParisLife(0.01, 1.0 / 21.0), ParisLife({}, 1.0 / 41.0), ParisLife(0.01, 1.0 / 21.0, GrowthAt::Minimum)}) {
        std::cout << fmt::format("life from a/W = .3 to .5: {:.0f} cycles, handbook {:.0f}; {} computed\n", life.cycles,
                                 handbook, life.computed);
        EXPECT_NEAR(life.end, 0.5, 1e-9);
        // m times the error of K, .15 % at most against the handbook's .3
        EXPECT_NEAR(life.cycles, handbook, 0.01 * handbook);
        EXPECT_LE(life.computed, 21U);
    }
}

// The last increment is cut to where K reaches the toughness, as a power of the length tells: with all of it the cracks
// would end at a/W = .46.
TEST(CrackGrowth, LivesUntilKReachesTheToughness) {
    const double handbook = ParisLife::by_handbook(0.45);
    for (const double increment : {0.02, 0.04}) {
        const ParisLife life(increment, 1.0 / 21.0, GrowthAt::Maximum, ParisLife::K_at(0.45));
        std::cout << fmt::format("breaks at a/W = {:.4f} after {:.0f} cycles, handbook {:.0f}; {} computed\n", life.end,
                                 life.cycles, handbook, life.computed);
        EXPECT_NEAR(life.end, 0.45, 0.005);
        EXPECT_NEAR(life.cycles, handbook, 0.03 * handbook);
    }
}

// A load ratio of a half counts as half a range to the power of the exponent: so does each of the computed cycles.
TEST(CrackGrowth, LivesLongerByWalkersExponent) {
    const auto life = [](double ratio, double walker) {
        Case input = edge_crack(0.3, 4.0, End::Pulled);
        input.mesh.size = 1.0 / 21.0;
        input.load = {.steps = 2, .blocks = {{.cycles = 100, .max = 80.0, .min = 80.0 * ratio}}};
        input.growth = GrowthSection{
            .law = GrowthLaw::Paris, .increment = 0.05, .C = 1e-13, .m = 3.0, .walker = walker, .until = 0.5};
        double cycles = 0.0;
        for (const coarse::Increment& step : run_direct(input).increments)
            for (const coarse::CycleResult& cycle : step.cycles) cycles += cycle.dN;
        return cycles;
    };
    const double as_range = life(0.0, 0.4);
    EXPECT_NEAR(life(0.5, 0.4), std::exp2(3.0 * 0.4) * as_range, 1e-9 * as_range);
    EXPECT_NEAR(life(-1.0, 0.4), as_range, 1e-9 * as_range);
}

/// references 4.7.
const std::vector<double> ranges_of_steel{63.0, 363.0, 5000.0},
    rates_of_steel{1.21e-26 * std::pow(63.0, 8.16), 1.21e-26 * std::pow(363.0, 8.16),
                   3.98e-13 * std::pow(5000.0, 2.88)};

// Two fifths of the life are on the steep line, where K counts with the power of eight.
TEST(CrackGrowth, LivesAsLongAsATableSays) {
    Case input = edge_crack(0.3, 4.0, End::Pulled);
    input.mesh.size = 1.0 / 41.0;
    const double stress = 200.0;
    input.load = {.steps = 2, .blocks = {{.cycles = 200, .max = stress, .min = 0.0}}};
    input.growth = GrowthSection{
        .law = GrowthLaw::Table, .increment = 0.005, .ranges = ranges_of_steel, .rates = rates_of_steel, .until = 0.5};
    double handbook = 0.0, cycles = 0.0, steep = 0.0;
    for (int k = 0; k < 2000; ++k) {
        const double a = 0.3 + 0.2 * (k + 0.5) / 2000.0;
        const double K = stress * coarse::sent_factor(a) * std::sqrt(std::numbers::pi * a);
        const double rate = K < 363.0 ? 1.21e-26 * std::pow(K, 8.16) : 3.98e-13 * std::pow(K, 2.88);
        handbook += 0.2 / 2000.0 / rate;
        if (K < 363.0) steep += 0.2 / 2000.0 / rate;
    }
    for (const coarse::Increment& step : run_direct(input).increments)
        for (const coarse::CycleResult& cycle : step.cycles) cycles += cycle.dN;
    std::cout << fmt::format("life by a table: {:.0f} cycles, handbook {:.0f}, {:.0f} of them on the steep line\n",
                             cycles, handbook, steep);
    EXPECT_NEAR(cycles, handbook, 0.015 * handbook);
}

// A run ends in order where the crack has no metal left to grow through.
TEST(CrackGrowth, EndsBeforeTheCrackLeavesTheBody) {
    Case input = edge_crack(0.7, 3.0, End::Pulled);
    input.mesh.size = 1.0 / 11.0;
    input.load = {.steps = 2, .blocks = {{.cycles = 20, .max = 1.0, .min = 0.0}}};
    input.growth.emplace().increment = 0.08;
    const RunHistory run = run_direct(input);
    EXPECT_NEAR(run.increments.back().tips[0].a, 0.86, 1e-12);  // the next tip is nearer to the edge than an element
}

// A point that is held on the way of a crack stops the run, as no ring fits in beside it, and not the crack.
TEST(CrackGrowth, IsNoLifeBeforeAHeldNode) {
    Case input = edge_crack(0.7, 3.0, End::Pulled);
    input.mesh.size = 1.0 / 11.0;
    input.load = {.steps = 2, .blocks = {{.cycles = 20, .max = 1.0, .min = 0.0}}};
    input.growth = GrowthSection{.law = GrowthLaw::Paris, .increment = 0.04, .C = 1e-13, .m = 3.0};
    const RunHistory free = run_direct(input);
    EXPECT_TRUE(free.life_is_over);  // at the far edge
    BoundarySection held;
    held.on = "point";
    held.at = Vec2(0.9, 1.5);
    held.displacement[0] = 0.0;
    input.boundaries.push_back(held);
    const RunHistory stopped = run_direct(input);
    EXPECT_LT(stopped.increments.back().tips[0].a, free.increments.back().tips[0].a);
    EXPECT_FALSE(stopped.life_is_over);
}

/// Plane stress, R = 0: twelve cycles of growth through elements of 0.1 mm at the tip.
Case growing_plate(PlaneState plane) {
    Case input =
        sent_case({"mesh.grading=[]", "mesh.height=102.5", "mesh.size=2.5", "fine.refine=32",
                   "crack.0.points=[[0.0, 51.25], [20.0, 51.25]]", "crack.0.notch=19.0",
                   "load.blocks=[{cycles=12, max=30.0, ratio=0.0}]", "load.steps=20", "growth.increment=0.05"});
    input.model.plane = plane;
    return input;
}

TEST(CrackGrowth, TheWakeClosesBeforeTheLoadIsGone) {
    const RunHistory run = run_direct(growing_plate(PlaneState::Stress));
    EXPECT_EQ(run.cuts, 0);
    double opened_last = 0.0;
    for (const coarse::Increment& increment : run.increments) {
        for (const coarse::OpeningChange& change : increment.opening_changes)
            if (!change.closes) opened_last = change.load_factor / 30.0;
    }
    std::cout << fmt::format("plane stress, R = 0, a = {:.2f}: last opened at {:.3f} of the maximum\n",
                             run.increments.back().tips[0].a, opened_last);
    EXPECT_GT(opened_last, 0.3);
    EXPECT_LT(opened_last, 0.6);
    EXPECT_NEAR(run.increments.back().tips[0].a, 20.6, 1e-9);
}

}  // namespace
}  // namespace stria::test
