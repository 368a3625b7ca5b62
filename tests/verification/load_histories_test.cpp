// Growing cracks under loads that follow them or change: control of K, K gradients, sequences.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/support/load_cases.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

Case elastic_plate() {
    Case input = edge_crack(0.3, 3.0, End::Pulled);
    input.mesh.size = 1.0 / 21.0;
    input.load = {.steps = 2, .blocks = {{.cycles = 4, .max = 100.0, .min = 25.0}}};
    input.load.control = Control::StressIntensity;
    input.growth.emplace().increment = 0.031;
    return input;
}

/// Largest and smallest K of every cycle from the interaction integral, not the nominal one, and the length there.
struct Extremes {
    double a, K_max, K_min;
};
std::vector<Extremes> extremes_of(const RunHistory& run) {
    std::vector<Extremes> found;
    double K_min = 0.0;
    for (const coarse::Increment& increment : run.increments) {
        if (increment.step.at_minimum) K_min = increment.tips[0].K_I;
        if (increment.step.ends_cycle) found.push_back({increment.tips[0].a, increment.tips[0].K_I, K_min});
    }
    return found;
}

TEST(LoadHistories, TheLoadFollowsTheCrackWhereKIsControlled) {
    const std::vector<Extremes> cycles = extremes_of(run_direct(elastic_plate()));
    ASSERT_EQ(cycles.size(), 4U);
    for (const Extremes& cycle : cycles) {
        EXPECT_NEAR(cycle.K_max, 100.0, 1e-8);
        EXPECT_NEAR(cycle.K_min, 25.0, 1e-8);
    }
}

// ASTM E647: K = K_0 exp(C (a - a_0)).
TEST(LoadHistories, KChangesWithTheCrackAsAsked) {
    Case input = elastic_plate();
    input.load.K_gradient = -3.0;
    for (const Extremes& cycle : extremes_of(run_direct(input)))
        EXPECT_NEAR(cycle.K_max, 100.0 * std::exp(-3.0 * (cycle.a - 0.3)), 1e-8) << cycle.a;
}

// A computed cycle stands for many, each with the K that is held: dN = da / (C dK^m), wherever in the cycle the crack
// grows. The first growth in front of any cycle has no rate yet.
TEST(LoadHistories, ALifeAtConstantKIsThatOfTheLaw) {
    constexpr double C = 1e-12, m = 3.0;
    for (const GrowthAt at : {GrowthAt::Maximum, GrowthAt::Minimum}) {
        Case input = elastic_plate();
        input.load.blocks[0].cycles = 6;
        input.growth = GrowthSection{.law = GrowthLaw::Paris, .increment = 0.031, .at = at, .C = C, .m = m};
        double grown = 0.0, cycles = 0.0;
        for (const coarse::Increment& increment : run_direct(input).increments)
            for (const coarse::CycleResult& cycle : increment.cycles)
                if (cycle.dN > 0.0) grown += cycle.da, cycles += cycle.dN;
        EXPECT_GT(grown, 0.12);
        EXPECT_NEAR(cycles, grown / (C * std::pow(75.0, m)), 1e-6 * cycles);
    }
}

// A linear body closes its crack where the load is gone, however long it has become. So dK_eff is K_max.
TEST(LoadHistories, ALifeByOpeningLoadsOfALinearBodyIsThatOfKMax) {
    constexpr double C = 1e-12, m = 3.0;
    Case input = elastic_plate();
    input.cracks[0].contact.emplace();
    input.load.steps = 4;
    input.load.blocks = {{.cycles = 6, .max = 100.0, .min = -50.0}};
    input.growth = GrowthSection{
        .law = GrowthLaw::Paris, .increment = 0.031, .C = C, .m = m, .driving = GrowthDriving::EffectiveRange};
    double grown = 0.0, cycles = 0.0;
    for (const coarse::Increment& increment : run_direct(input).increments)
        for (const coarse::CycleResult& cycle : increment.cycles) {
            EXPECT_NEAR(cycle.opening.K_op, 0.0, 0.002 * 100.0);  // how well it is located
            if (cycle.dN > 0.0) grown += cycle.da, cycles += cycle.dN;
        }
    EXPECT_GT(grown, 0.12);
    EXPECT_NEAR(cycles, grown / (C * std::pow(100.0, m)), 0.006 * cycles);
}

// Between constant loads: the life is that of the law to the second order of the increment, wherever in the cycle the
// crack grows. At R = 0.7 a K_min of the shorter crack would make the range by a quarter too large.
TEST(LoadHistories, ALifeBetweenConstantLoadsIsTheSameWhereverItGrows) {
    std::vector<double> lives;
    for (const GrowthAt at : {GrowthAt::Maximum, GrowthAt::Minimum}) {
        Case input = elastic_plate();
        input.load.control = Control::Load;
        input.load.blocks = {{.cycles = 6, .max = 100.0, .min = 70.0}};
        input.growth = GrowthSection{.law = GrowthLaw::Paris, .increment = 0.031, .at = at, .C = 1e-12, .m = 3.0};
        double cycles = 0.0;
        for (const coarse::Increment& increment : run_direct(input).increments)
            for (const coarse::CycleResult& cycle : increment.cycles) cycles += cycle.dN;
        lives.push_back(cycles);
    }
    EXPECT_NEAR(lives[1], lives[0], 1e-6 * lives[0]);
}

double life(const Case& input) {
    double cycles = 0.0;
    for (const coarse::Increment& increment : run_direct(input).increments)
        for (const coarse::CycleResult& cycle : increment.cycles) cycles += cycle.dN;
    return cycles;
}

/// Bending that follows the load, by half of its factor, whose K changes in another way as the crack grows.
Case bent_too() {
    Case input = elastic_plate();
    input.load_cases = {lagging_load("bends", 0.5)};
    for (const double sign : {1.0, -1.0}) {
        BoundarySection& bends = input.boundaries.emplace_back(at_end(sign > 0.0 ? "top" : "bottom", End::Pulled, 0.0));
        bends.traction_gradient(1, 0) = -6.0 * sign;
        bends.origin = {0.5, 0.0};
        bends.load_case = "bends";
    }
    return input;
}

// So it is between values of K that are asked for, below zero, beside an initial stress, whose K changes as the crack
// grows, and beside a load that follows the first: with K_min of the shorter crack lives were 10 % to a factor of two
// apart, with the load of a follower likewise a half apart.
TEST(LoadHistories, ALifeBetweenConstantKIsTheSameWhereverItGrows) {
    Case pressed = elastic_plate(), steep = elastic_plate(), stressed = elastic_plate(), bent = bent_too();
    pressed.load.blocks = {{.cycles = 6, .max = 100.0, .min = -50.0}};
    steep.load.blocks = stressed.load.blocks = bent.load.blocks = {{.cycles = 6, .max = 100.0, .min = 70.0}};
    steep.load.K_gradient = 3.0;
    stressed.initial_stress.emplace().sigma_y =
        StressProfile{.at = {0.0, 0.25, 0.5, 0.75, 1.0}, .stress = {150.0, 0.0, -150.0, 0.0, 150.0}};
    for (Case* input : {&pressed, &steep, &stressed, &bent}) {
        input->growth = GrowthSection{.law = GrowthLaw::Paris, .increment = 0.031, .C = 1e-12, .m = 3.0};
        input->growth->driving = input == &pressed ? GrowthDriving::FullRange : GrowthDriving::Range;
        const double at_maximum = life(*input);
        input->growth->at = GrowthAt::Minimum;
        EXPECT_NEAR(life(*input), at_maximum, 1e-6 * at_maximum);
    }
}

// By openings too: that of the minimum is told for the K that is asked of the longer crack, of which the load under
// which it has grown is too large by a quarter of the range here. Lives were 92 % apart.
TEST(LoadHistories, ALifeByOpeningsBetweenConstantKIsTheSameWhereverItGrows) {
    Case input = elastic_plate();
    input.load.blocks = {{.cycles = 6, .max = 100.0, .min = 70.0}};
    input.closure.distance = 0.1;
    input.growth = GrowthSection{.law = GrowthLaw::Ctod, .increment = 0.031, .C = 1.0, .m = 2.0};
    const double at_maximum = life(input);
    input.growth->at = GrowthAt::Minimum;
    EXPECT_NEAR(life(input), at_maximum, 1e-6 * at_maximum);
}

// A sequence of four cycles and a peak, again and again: a growth takes da / (mean rate) of its cycles, whichever of
// them is the last one, and the peak counts once.
TEST(LoadHistories, ALifeUnderARepeatedSequenceIsThatOfItsMeanRate) {
    constexpr double C = 1e-12, m = 3.0, da = 0.031;
    const LoadBlock small{.cycles = 4, .max = 100.0, .min = 25.0}, peak{.cycles = 1, .max = 160.0, .min = 25.0};
    const double mean = C * (4.0 * std::pow(75.0, m) + std::pow(135.0, m)) / 5.0;
    for (const GrowthAt at : {GrowthAt::Maximum, GrowthAt::Minimum})
        for (const std::vector<LoadBlock>& blocks : {std::vector{small, peak}, std::vector{peak, small}}) {
            Case input = elastic_plate();
            input.load.blocks = blocks;
            input.load.repeat = 4;
            input.growth =
                GrowthSection{.law = GrowthLaw::Paris, .increment = da, .every = 5, .at = at, .C = C, .m = m};
            std::vector<double> counted;
            for (const coarse::Increment& increment : run_direct(input).increments)
                for (const coarse::CycleResult& cycle : increment.cycles)
                    if (cycle.dN > 0.0) counted.push_back(cycle.dN);
            // Where the last cycle returns to its own maximum, and not to that of the sequence, the mean before it
            // counts. At minima four cycles are in front of the first chance to grow, and the last cycle begins another
            // one: neither is a whole sequence.
            ASSERT_EQ(counted.size(), at == GrowthAt::Maximum ? 3U : 2U);
            for (const double cycles : counted) EXPECT_NEAR(cycles, da / mean, 1e-6 * cycles);
        }
}

// Whether the crack is to grow there or not.
TEST(LoadHistories, TheCrackBreaksInTheCycleThatReachesItsToughness) {
    const auto last_cycle = [](const Case& input) { return run_direct(input).increments.back().step.cycle; };
    Case input = elastic_plate();
    input.growth->at = GrowthAt::Minimum;
    input.growth->toughness = 110.0;
    input.load.blocks = {{.cycles = 2, .max = 100.0, .min = 25.0}, {.cycles = 2, .max = 120.0, .min = 25.0}};
    EXPECT_EQ(last_cycle(input), 2);
    input.growth->at = GrowthAt::Maximum;
    input.growth->every = 4;
    EXPECT_EQ(last_cycle(input), 2);
    input.growth->toughness = 130.0;
    EXPECT_EQ(last_cycle(input), 4);
}

// The crack grows at an overload, and is longer when cycles of less follow: the load of the overload does not come
// again.
TEST(LoadHistories, NoCrackBreaksByALoadThatIsGone) {
    Case input = elastic_plate();
    input.load.control = Control::Load;
    input.load.blocks = {{.cycles = 2, .max = 100.0, .min = 0.0}, {.cycles = 3, .max = 60.0, .min = 0.0}};
    double reached = 0.0;
    const RunHistory run = run_direct(input);
    for (const coarse::Increment& increment : run.increments)
        for (const coarse::CycleResult& cycle : increment.cycles) reached = std::max(reached, cycle.K_max);
    input.growth->toughness = 1.02 * reached;
    ASSERT_GT(100.0 * run.nominal[0].K_I, *input.growth->toughness) << "of the overload, had it come again";
    EXPECT_EQ(run_direct(input).increments.back().step.cycle, 5);
}

// A crack breaks in the first cycle whose maximum reaches the toughness, be it an overload amid cycles after which
// nothing grows, or the cracks grow at minima: K_max has reached it in the last cycles, from one growth to the next,
// and in none before.
TEST(LoadHistories, ToughnessEndsALifeAtThePeakOfASequence) {
    constexpr double toughness = 153.0;
    for (const GrowthAt at : {GrowthAt::Maximum, GrowthAt::Minimum})
        for (const GrowthLaw law : {GrowthLaw::Paris, GrowthLaw::Prescribed}) {
            Case input = elastic_plate();
            input.load.K_gradient = 1.0;  // 1/mm: 2 % more with two growths
            input.load.blocks = {{.cycles = 3, .max = 100.0, .min = 25.0}, {.cycles = 1, .max = 150.0, .min = 15.0}};
            input.load.repeat = 20;
            input.growth = GrowthSection{.law = law, .increment = 0.01, .every = 4, .at = at, .C = 1e-12, .m = 3.0};
            input.growth->toughness = toughness;
            std::vector<double> K_max;
            for (const coarse::Increment& increment : run_direct(input).increments)
                for (const coarse::CycleResult& cycle : increment.cycles) K_max.push_back(cycle.K_max);
            const auto first = std::ranges::find_if(K_max, [](double K) { return K >= toughness; });
            ASSERT_NE(first, K_max.end());
            EXPECT_LT(K_max.end() - first, 5) << K_max.size();
        }
}

constexpr double C_of_bent = 1e-12, m_of_bent = 3.0, increment_of_bent = 0.1;

/// A crack inside that is bent open at one end.
Case bent_open(int cycles) {
    Case input = specimen("plate", 40.0, {{18.0, 20.0}, {22.0, 20.0}});
    input.mesh.width = 40.0;
    input.mesh.size = 40.0 / 81.0;
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    for (BoundarySection& end : input.boundaries) {
        end.traction_gradient(1, 0) = 0.3 * end.traction->y();
        end.origin = Vec2(20.0, 0.0);
    }
    input.load = {.steps = 2, .blocks = {{.cycles = cycles, .max = 10.0, .min = 0.0}}};
    input.growth =
        GrowthSection{.law = GrowthLaw::Paris, .increment = increment_of_bent, .C = C_of_bent, .m = m_of_bent};
    return input;
}

std::vector<std::vector<coarse::CycleResult>> cycles_of(const Case& input) {
    std::vector<std::vector<coarse::CycleResult>> cycles;
    for (const coarse::Increment& step : run_direct(input).increments)
        if (!step.cycles.empty()) cycles.push_back(step.cycles);
    return cycles;
}

double rate(const coarse::CycleResult& cycle) { return C_of_bent * std::pow(cycle.K_max, m_of_bent); }

// It grows by its fast tip's law: da = C dK^m dN of every tip, where half of the crack grows by the mean of both. The
// first growth knows one rate, those behind it go by the rates in their middle.
TEST(LoadHistories, EachOfTwoTipsGrowsByItsOwnRate) {
    constexpr double increment = increment_of_bent;
    const std::vector<std::vector<coarse::CycleResult>> cycles = cycles_of(bent_open(5));
    ASSERT_EQ(cycles.size(), 5U);
    for (std::size_t k = 1; k < cycles.size(); ++k) {
        const coarse::CycleResult &slow = cycles[k][0], &fast = cycles[k][1], &before = cycles[k - 1][1];
        EXPECT_LT(rate(slow), 0.5 * rate(fast));
        EXPECT_NEAR(fast.da, increment, 1e-9);
        const double at_begin = rate(cycles[k - 1][0]) / rate(before), at_end = rate(slow) / rate(fast);
        if (k == 1) {
            EXPECT_NEAR(slow.da, increment * at_begin, 1e-9);
        } else {
            EXPECT_GT(std::abs(at_begin / at_end - 1.0), 0.02);
            EXPECT_NEAR(slow.da, increment * std::midpoint(at_begin, at_end), 0.002 * slow.da);
        }
        EXPECT_NEAR(fast.dN, 0.5 * increment * (1.0 / rate(before) + 1.0 / rate(fast)), 1e-6 * fast.dN);
    }
}

// Not a whole increment behind it, nor in front of it by what both tips are off by.
TEST(LoadHistories, ALifeEndsWhereTheCrackIsAsLongAsAskedFor) {
    Case input = bent_open(50);
    for (const double until : {2.27, cycles_of(bent_open(4)).back()[0].a + 1e-6}) {
        input.growth->until = until;
        const std::vector<std::vector<coarse::CycleResult>> cycles = cycles_of(input);
        const coarse::CycleResult &last = cycles.back()[1], &before = *(cycles.end()[-2].begin() + 1);
        EXPECT_NEAR(last.a, until, 2e-6);
        EXPECT_EQ(cycles.size(), until == 2.27 ? 6U : 4U);
        EXPECT_NEAR(last.dN, 0.5 * last.da * (1.0 / rate(before) + 1.0 / rate(last)), 1e-6 * last.dN);
    }
}

}  // namespace
}  // namespace stria::test
