// K_I of a tip whose faces are pressed shut: of the loads and of the pressure on the faces together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/comparison.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

constexpr double half_crack = 10.0, width = 400.0, opening = 120.0, closing = -200.0;

/// Large enough to be an infinite one to 0.2 %. Pulled, then pressed.
Case pressed_plate(bool plastic) {
    Case input =
        specimen("mt", width, {{0.5 * width - half_crack, 0.5 * width}, {0.5 * width + half_crack, 0.5 * width}});
    input.mesh.width = width;
    input.mesh.size = 20.0;
    input.mesh.grading = {{.at = {{0.5 * width - half_crack, 0.5 * width}, {0.5 * width + half_crack, 0.5 * width}},
                           .size = 0.2,
                           .outer_size = 0.5,
                           .radius = 1.0}};
    if (plastic) input.material.yield_stress = 300.0;
    if (plastic) input.material.kinematic = {{.C = 4000.0, .gamma = 0.0}};
    input.cracks[0].contact = ContactSection{};
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load.steps = 12;
    input.load.blocks = {{.cycles = 1, .max = opening, .min = closing}};
    return input;
}

/// docs/references.md 2.9.
double K_of_pressure(const std::vector<coupling::FaceSample>& faces) {
    double sum = 0.0;
    for (std::size_t k = 1; k < faces.size(); ++k) {
        const auto angle = [&](std::size_t i) {
            return std::asin(std::clamp(faces[i].s / half_crack - 1.0, -1.0, 1.0));
        };
        sum += 0.5 * (faces[k - 1].pressure + faces[k].pressure) * (angle(k) - angle(k - 1));
    }
    return sum * std::sqrt(half_crack / std::numbers::pi);
}

TEST(ClosedTip, OfAnElasticBodyHasNoKAndNoJ) {
    const Followed pressed = run_direct(pressed_plate(false)).at_minimum();
    const double K = std::abs(closing) * std::sqrt(std::numbers::pi * half_crack);
    EXPECT_NEAR(pressed.zone.contact_length[0], 2.0 * half_crack, 1e-9);
    for (const coarse::TipResult& tip : pressed.tips) {
        EXPECT_LT(std::abs(tip.K_I), 1e-5 * K);
        EXPECT_LT(std::abs(tip.J), 1e-9 * K * K / plane_modulus);
    }
}

// Without functions faces end on an edge, here 0.07 mm off the tips, and what presses on them counted at its distance
// from the tips: 3 % of K were left.
TEST(ClosedTip, WhoseFacesEndBesideItHasNextToNoK) {
    Case input = pressed_plate(false);
    input.fine.enrichment = Enrichment::None;
    input.cracks[0].points = {{0.5 * width - half_crack - 0.07, 0.5 * width},
                              {0.5 * width + half_crack + 0.07, 0.5 * width}};
    const double K = std::abs(closing) * std::sqrt(std::numbers::pi * half_crack);
    for (const coarse::TipResult& tip : run_direct(input).at_minimum().tips) EXPECT_LT(std::abs(tip.K_I), 0.01 * K);
}

// Slender arms, pulled apart at their ends: faces that touch part one after the other, more of them than there are
// iterations, and at any load. Every increment was halved in vain.
TEST(ClosedTip, OpensBetweenSlenderArmsInOneIncrement) {
    constexpr double arm = 5.0, crack = 50.0, force = 10.0;
    Case input = specimen("plate", 2.0 * arm, {{0.0, arm}, {crack, arm}});
    input.mesh.width = 100.0;
    input.mesh.size = 2.0;
    input.mesh.grading = {
        {.at = {{0.0, arm}, {crack, arm}}, .size = 0.2, .outer_size = 0.2, .radius = 1.0, .growth = 0.3}};
    input.cracks[0].contact = ContactSection{};
    for (const double y : {2.0 * arm, 0.0}) {
        BoundarySection& end = input.boundaries.emplace_back();
        end.on = "point";
        end.at = Vec2(0.0, y);
        end.force = Vec2(0.0, y > arm ? 1.0 : -1.0);
    }
    input.load.steps = 2;
    input.load.blocks = {{.cycles = 1, .max = force, .min = 0.0}};
    const RunHistory run = run_direct(input);
    EXPECT_EQ(run.cuts, 0);
    // Two built-in beams, each longer by 0.673 of its height (Gross, Srawley 1966).
    const double K = 2.0 * std::sqrt(3.0) * force * crack / std::pow(arm, 1.5) * (1.0 + 0.673 * arm / crack);
    EXPECT_NEAR(run.at_load(force).tips[0].K_I, K, 0.01 * K);
    EXPECT_EQ(run.at_load(force).zone.contact_length[0], 0.0);
}

// Of a crack of three and a half elements whose faces open and close at no load. No multiplier may stand between the
// place where contact is looked at and the middle of the crack, and yet its faces are pressed there: K_op was K_min.
TEST(ClosedTip, OfAShortCrackOpensAtNoLoadAtBothEnds) {
    Case input =
        specimen("plate", 20.0, {{3.6966341607599564, 8.46854040617404}, {5.846190507728574, 11.226763742586297}});
    input.mesh.width = 10.0;
    input.mesh.size = 10.0 / 13.0;
    input.cracks[0].contact = ContactSection{};
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load = {.steps = 4, .blocks = {{.cycles = 1, .max = 50.0, .min = -50.0}}};
    input.closure.distance = 1.0;
    for (const bool reversed : {false, true}) {
        if (reversed) std::ranges::reverse(input.cracks[0].points);
        const RunHistory run = run_direct(input);
        for (const coarse::CycleResult& tip : run.increments.back().cycles)
            EXPECT_LT(std::abs(tip.opening.K_op), 0.05 * tip.K_max) << reversed;
    }
}

// Metal that has been stretched bears a part of the load ahead of the tip, and holds the faces behind it apart: the
// faces press less than the load wants, and the tip is pushed together.
TEST(ClosedTip, OfAPlasticBodyIsPushedTogetherByWhatItsFacesDoNotBear) {
    const RunHistory run = run_direct(pressed_plate(true));
    const Followed& pressed = run.at_minimum();
    EXPECT_GT(pressed.zone.contact_length[0], 1.8 * half_crack);
    const double K = run.nominal[0].K_I * closing, by_faces = K_of_pressure(pressed.zone.faces);
    const auto row = rows_of({.scene = "closed crack with a plastic wake, pressed",
                              .source = "Tada, Paris, Irwin (2.9)",
                              .within = 0.005,
                              .mesh = "0.2 mm at the tip",
                              .scale = std::abs(K)});
    for (const coarse::TipResult& tip : pressed.tips) {
        EXPECT_LT(tip.K_I, 0.0);
        row("K_I at the smallest load, MPa sqrt(mm)", K + by_faces, tip.K_I);
    }
    EXPECT_LT(K + by_faces, 0.04 * K) << "not all is borne by the faces";
}

}  // namespace
}  // namespace stria::test
