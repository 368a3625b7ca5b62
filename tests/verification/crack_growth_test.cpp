// Cracks that grow: the state stays, equilibrium is found again, and the wake closes (DESIGN section 4).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iostream>

#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

// An elastic body has no memory: after any growth K is that of the longer crack from the start.
TEST(CrackGrowth, AnElasticBodyForgetsHowTheCrackCameThere) {
    Case input = edge_crack(0.3, 3.0, End::Pulled);
    input.mesh.size = 1.0 / 21.0;
    input.load = {.steps = 2, .blocks = {{.cycles = 3, .max = 1.0, .min = 0.0}}};
    input.growth = GrowthSection{.law = "prescribed", .increment = 0.031};
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
        for (const coarse::ContactChange& change : increment.contact_changes)
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
