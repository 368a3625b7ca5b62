// Where growing cracks go: across the load, as the maximum tells, back over an edge, or straight on.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <iostream>

#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

/// A crack in the middle of a square, at about 37 degrees to the normal of the load, that grows at both tips.
Case inclined_crack(double growth, int cycles) {
    Case input = specimen("plate", 50.0, {{21.0, 22.0}, {29.0, 28.0}});
    input.mesh.width = 50.0;
    input.mesh.size = 50.0 / 61.0;
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load = {.steps = 8, .blocks = {{.cycles = cycles, .max = 70.0, .min = 0.0}}};
    input.growth.emplace().increment = growth;
    return input;
}

// A crack cannot leave an element edge between two nodes. Beside the middle of a plate the hoop stress asks for it.
TEST(CrackGrowth, GoesStraightOnWhereTheMeshCannotHoldASmallTurn) {
    const double element = 50.0 / 41.0, begin = 6.5 * element, row = 20.0 * element, step = 0.6 * element;
    Case input = specimen("plate", 50.0, {{0.0, row}, {begin, row}});
    input.mesh.width = 50.0;
    input.mesh.size = element;
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load = {.steps = 2, .blocks = {{.cycles = 4, .max = 1.0, .min = 0.0}}};
    input.growth.emplace().increment = step;
    const RunHistory run = run_direct(input);
    const coarse::TipResult &first = run.increments.front().tips[0], &last = run.increments.back().tips[0];
    EXPECT_GT(std::abs(first.K_II), 2e-4 * first.K_I);
    EXPECT_NEAR(last.a, begin + 4.0 * step, 1e-2 * step);
}

TEST(CrackGrowth, TurnsAcrossTheLoadUntilNothingSlides) {
    const RunHistory run = run_direct(inclined_crack(0.6, 6));
    const auto &first = run.increments.front().tips, &last = run.increments.back().tips;
    ASSERT_EQ(last.size(), 2U);
    for (const std::size_t t : {0, 1}) {
        std::cout << fmt::format("tip {}: K_II / K_I {:+.3f} before, {:+.3f} after\n", t, first[t].K_II / first[t].K_I,
                                 last[t].K_II / last[t].K_I);
        EXPECT_GT(std::abs(first[t].K_II), 0.5 * first[t].K_I);
        EXPECT_LT(std::abs(last[t].K_II), 0.03 * last[t].K_I);
        EXPECT_NEAR(last[t].a, 5.0 + 6.0 * 0.6, 1e-9);
    }
    EXPECT_NEAR(last[0].K_I, last[1].K_I, 0.01 * last[0].K_I);
}

// At the minimum its faces rub, and the K that they let through would turn it otherwise.
TEST(CrackGrowth, TurnsAsTheMaximumTellsWhereverInTheCycleItGrows) {
    Case input = inclined_crack(0.6, 1);
    input.mesh.size = 50.0 / 31.0;
    input.load.steps = 4;
    input.cracks[0].contact = ContactSection{.friction = 0.3};
    input.load.blocks[0].min = -70.0;
    const auto place = [&](GrowthAt where) {
        input.growth->at = where;
        const RunHistory run = run_direct(input);
        const double a = run.increments.front().tips[1].a;
        const auto grown = std::ranges::find_if(run.increments, [&](const auto& i) { return i.tips[1].a > a + 0.1; });
        return Vec2(grown->tips[1].x, grown->tips[1].y);
    };
    EXPECT_LT((place(GrowthAt::Minimum) - place(GrowthAt::Maximum)).norm(), 1e-6);
}

// The same with flow and contact: the bend passes through elements that keep their points.
TEST(CrackGrowth, TurnsThroughFlowedMetal) {
    Case input = inclined_crack(0.15, 4);
    input.material.yield_stress = 300.0;
    input.material.kinematic = {{.C = 4000.0, .gamma = 0.0}};
    input.cracks[0].contact = ContactSection{};
    const RunHistory run = run_direct(input);
    EXPECT_EQ(run.cuts, 0);
    const auto& last = run.increments.back().tips;
    EXPECT_NEAR(last[0].K_I, last[1].K_I, 1e-4 * last[0].K_I);  // what is said of one end holds of the other
    for (const coarse::TipResult& tip : last) EXPECT_TRUE(std::isnan(tip.J)) << "nearer than four elements to the bend";
    for (const coarse::TipResult& tip : last) EXPECT_LT(std::abs(tip.K_II), 0.1 * tip.K_I);
}

/// An edge crack that has come over an edge into the next row by a part of an element, and that shear turns back.
Case turned_back(double beyond_edge, int elements, bool yields) {
    const double size = 50.0 / elements, row = std::round(30.0 / (50.0 / 61.0)) * (50.0 / 61.0);
    const double beyond = beyond_edge * 50.0 / 61.0;
    Case input = specimen("plate", 50.0, {{0.0, row - 6.0 + beyond}, {12.3, row + beyond}});
    input.mesh.width = 50.0;
    input.mesh.size = size;
    const auto pulled = [&](const char* on, double along, double across) {
        BoundarySection side = at_end(on, End::Pulled, 1.0);
        side.traction = Vec2(along, across);
        input.boundaries.push_back(side);
    };
    input.boundaries.clear();
    pulled("top", 0.4, 1.0);
    pulled("bottom", -0.4, -1.0);
    pulled("left", 0.0, -0.4);
    pulled("right", 0.0, 0.4);
    input.load = {.steps = 4, .blocks = {{.cycles = 3, .max = 40.0, .min = 0.0}}};
    input.growth.emplace().increment = 1.0;
    if (yields) {
        input.material.yield_stress = 300.0;
        input.material.kinematic = {{.C = 4000.0, .gamma = 0.0}};
        input.cracks[0].contact = ContactSection{};
    }
    return input;
}

// Growth ended after a step there: the crack would enter an element twice.
void expect_that_it_turns_back(std::initializer_list<double> places) {
    for (const bool yields : {false, true}) {
        for (const double beyond : places) {
            const coarse::TipResult tip = run_direct(turned_back(beyond, 61, yields)).increments.back().tips[0],
                                    fine = run_direct(turned_back(beyond, 127, yields)).increments.back().tips[0];
            std::cout << fmt::format("{} of an element beyond the edge: ends at {:.4f}, {:.4f}, K {:.2f}; {:.4f}, "
                                     "{:.4f}, {:.2f} on other elements\n",
                                     beyond, tip.x, tip.y, tip.K_I, fine.x, fine.y, fine.K_I);
            EXPECT_NEAR(tip.a, fine.a, 0.1);
            EXPECT_LT(std::hypot(tip.x - fine.x, tip.y - fine.y), 0.1);
            EXPECT_NEAR(tip.K_I, fine.K_I, 0.02 * fine.K_I);
        }
    }
}

TEST(CrackGrowth, TurnsBackOverAnEdge) { expect_that_it_turns_back({0.1}); }
TEST(CrackGrowth, TurnsBackNearerAndFartherBeyondAnEdgeLong) { expect_that_it_turns_back({0.03, 0.2}); }

}  // namespace
}  // namespace stria::test
