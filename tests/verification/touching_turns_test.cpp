// Where a crack goes whose faces touch: as the solution says in which they do, with friction and without. What a wake
// presses on itself with turns nobody.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "coarse/analysis/nominal_body.hpp"
#include "tests/support/load_cases.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

/// A plate under compression with a crack at 45 degrees, pressed shut from end to end: it slides, and wings grow.
Case plate_with_wings(double friction, int cycles) {
    const std::vector<Vec2> points{{14.0, 14.0}, {26.0, 26.0}};
    Case input = specimen("plate", 40.0, points);
    input.mesh.width = 40.0;
    input.mesh.size = 2.0;
    input.mesh.grading.clear();
    for (const Vec2& tip : points)
        input.mesh.grading.push_back({.at = {tip}, .size = 0.5, .outer_size = 1.0, .radius = 4.0});
    input.cracks[0].contact = ContactSection{friction};
    input.fine.enrichment = Enrichment::None;  // or friction chooses other functions
    input.boundaries = {at_end("top", End::Pulled, -1.0), at_end("bottom", End::Pulled, 1.0)};
    input.load.blocks = {{.cycles = cycles, .max = 40.0, .min = 0.0}};
    input.load.steps = 4;
    input.growth = GrowthSection{.increment = 0.5};
    return input;
}

// Without friction they went by the K of faces that pass through each other: 51 degrees in their second step, and 0.5
// mm astray in the fourth.
TEST(TouchingTurns, WithoutFrictionAreThoseWithNextToNone) {
    const RunHistory smooth = run_direct(plate_with_wings(0.0, 3)), rough = run_direct(plate_with_wings(1e-9, 3));
    for (std::size_t t = 0; t < 2; ++t) {
        const coarse::TipResult &of_smooth = smooth.increments.back().tips[t],
                                &of_rough = rough.increments.back().tips[t];
        EXPECT_NEAR(of_smooth.x, of_rough.x, 1e-6);
        EXPECT_NEAR(of_smooth.y, of_rough.y, 1e-6);
    }
}

// A crack that goes where the hoop stress is largest is left with little K_II.
TEST(TouchingTurns, LeaveWingsWithoutK_II) {
    const RunHistory run = run_direct(plate_with_wings(0.0, 5));
    for (const coarse::TipResult& tip : run.increments.back().tips) {
        EXPECT_GT(tip.K_I, 50.0);
        EXPECT_LT(std::abs(tip.K_II), 0.15 * tip.K_I);
    }
}

// Pressed and let go is pulled and let go by the load turned around, and so where a rest of it stays. By what is left
// at the end of its pressing nominal K turned them, 0.7 mm astray, and under a rest what friction has kept of K.
TEST(TouchingTurns, AreThoseOfTheLoadTurnedAround) {
    for (const double rest : {0.0, 1.0}) {
        Case input = plate_with_wings(0.3, 4);
        input.load.blocks = {{.cycles = 4, .max = 40.0, .min = rest}};
        const RunHistory pulled = run_direct(input);
        input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
        input.load.blocks = {{.cycles = 4, .max = -rest, .min = -40.0}};
        const RunHistory pressed = run_direct(input);
        for (std::size_t t = 0; t < 2; ++t) {
            const coarse::TipResult &one = pulled.increments.back().tips[t], &other = pressed.increments.back().tips[t];
            EXPECT_NEAR(one.x, other.x, 1e-6) << rest;
            EXPECT_NEAR(one.y, other.y, 1e-6) << rest;
        }
    }
}

// In metal that flows no ring tells K behind their bends, and the K of faces that pass through each other turned them:
// they ended 0.6 to 0.7 mm from where they go without flow.
TEST(TouchingTurns, OfMetalThatFlowsAreNearlyThoseOfMetalThatDoesNot) {
    for (const double friction : {0.0, 0.3}) {
        Case input = plate_with_wings(friction, 4);
        const RunHistory elastic = run_direct(input);
        input.material.yield_stress = 100.0;
        const RunHistory flows = run_direct(input);
        bool any = false;
        for (std::size_t t = 0; t < 2; ++t) {
            const coarse::TipResult &far = flows.increments.back().tips[t], &as = elastic.increments.back().tips[t];
            any = any || far.rings_flow;
            EXPECT_LT(std::hypot(far.x - as.x, far.y - as.y), 0.08) << friction;
        }
        EXPECT_TRUE(any);
    }
}

// Behind an overload the wake touches at the maximum of the small cycles. K holds what it presses with, a third of
// nominal K, and what turns tips does not: it is the same as before the wake touched, but for the length.
TEST(TouchingTurns, AreNotThoseOfAWakeThatTouches) {
    Case input =
        sent_case({"mesh.size=10.0", mesh_at_tip(0.2), "model.plane=stress", "load.steps=8", "growth.increment=0.1",
                   "load.blocks=[{cycles=2,max=20.0,ratio=0.0},{cycles=1,max=40.0,ratio=0.0},"
                   "{cycles=4,max=12.0,ratio=0.0}]"});
    double open = 0.0, farthest = 0.0, largest = 0.0;
    int closed = 0;
    for (const Followed& now : run_direct(input).increments) {
        if (!now.step.at_maximum || now.step.cycle < 4) continue;
        const coarse::TipResult& tip = now.tips.at(0);
        EXPECT_FALSE(tip.rings_flow);
        if (tip.contact_length == 0.0) {
            EXPECT_EQ(tip.K_I_of_wake, 0.0);
            open = tip.K_I;
        } else {
            ++closed;
            largest = std::max(largest, tip.K_I / open);
            farthest = std::max(farthest, std::abs((tip.K_I - tip.K_I_of_wake) / open - 1.0));
        }
    }
    EXPECT_GE(closed, 2);
    EXPECT_GT(largest, 1.2);
    EXPECT_LT(farthest, 0.01);
}

/// A straight crack whose wake touches behind an overload, and a shear that comes on at the last maximum.
Case sheared_wake(double friction) {
    Case input = sent_case({"mesh.size=10.0", mesh_at_tip(0.2), "model.plane=stress", "load.steps=8",
                            "growth.increment=0.1", "growth.direction=straight",
                            "load.blocks=[{cycles=2,max=20.0,ratio=0.0},{cycles=1,max=40.0,ratio=0.0},"
                            "{cycles=4,max=12.0,ratio=0.0}]"});
    input.cracks[0].contact->friction = friction;
    input.load_cases = {own_load("shear", {{.cycles = 6}, {.cycles = 1, .at_max = 4.0}})};
    for (const auto& [on, traction] : {std::pair("top", Vec2(1.0, 0.0)), std::pair("bottom", Vec2(-1.0, 0.0)),
                                       std::pair("right", Vec2(0.0, 1.0)), std::pair("left", Vec2(0.0, -1.0))})
        input.boundaries.push_back(pulled_in_case("shear", on, traction));
    return input;
}

// The metal that a wake has stretched bears its pressure, and not the shear that its faces brake with: K_II of rings
// outside all flow is that of an elastic body with these tractions.
TEST(TouchingTurns, KnowTheShearOfAWake) {
    const Case input = sheared_wake(0.3);
    const RunHistory run = run_direct(input);
    const auto sheared = [](const Followed& f) { return f.step.at_maximum && f.step.target.cases[0] > 0.0; };
    const Followed& reached = *std::ranges::find_if(run.increments, sheared);
    const coarse::TipResult& tip = reached.tips.at(0);
    ASSERT_FALSE(tip.rings_flow);
    Case longer = input;
    longer.cracks[0].points.back().x() = tip.x;
    const coarse::Scene scene = coarse::make_scene(longer, coarse::refined_scene(input).mesh);
    coarse::CoarseEffort effort;
    const coarse::Note silent = [](const std::string&) {};
    coarse::NominalBody body(effort, silent);
    coarse::StructureFactors shared;
    (void)body.solve(scene, {}, shared);
    const coarse::LoadFactors loads{reached.load_factor, reached.step.target.cases};
    const double of_loads = coarse::K_II_under(body.tips().at(0), loads);
    const double of_faces = body.K_of_faces(scene, loads, coarse::tractions_of(reached.zone.faces), shared)[0].K_II;
    EXPECT_LT(of_faces, -0.5 * of_loads);
    EXPECT_NEAR(tip.K_II, of_loads + of_faces, 0.01 * of_loads);
}

}  // namespace
}  // namespace stria::test
