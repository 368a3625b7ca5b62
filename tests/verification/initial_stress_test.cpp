// Stress before any load: what equilibrium makes of it, and K in it by weight functions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <tuple>

#include "common/fem/centre.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/initial_stresses.hpp"
#include "tests/support/layered_plates.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

/// Two layers of one strip, one of them too short by a misfit strain: Timoshenko (1925) has its curvature, and with it
/// the stress away from the ends.
TEST(InitialStress, ABimetalStripBendsAsTimoshenkoSays) {
    Case input = steel_plate(2.0, 40.0, 0.1);
    input.model.plane = PlaneState::Stress;
    input.material.poisson = 0.0;
    const double E1 = 200e3, E2 = 70e3, t1 = 1.2, t2 = 0.8, h = t1 + t2, misfit_strain = 1e-3;
    input.regions = {misfit({{t1, 0.0}, {h, 40.0}}, E2, E2 * misfit_strain)};
    const Settled settled(input);
    // Resultant and moment vanish: sigma_i = E_i (e0 + k x) + misfit.
    const double A = E1 * t1 + E2 * t2, B = (E1 * t1 * t1 + E2 * (h * h - t1 * t1)) / 2.0;
    const double C = (E1 * t1 * t1 * t1 + E2 * (h * h * h - t1 * t1 * t1)) / 3.0;
    const double N = -E2 * misfit_strain * t2, M = -E2 * misfit_strain * (h * h - t1 * t1) / 2.0;
    const double e0 = (N * C - M * B) / (A * C - B * B), k = (A * M - B * N) / (A * C - B * B);
    const double m = t1 / t2, n = E1 / E2;  // Timoshenko's own words, eq. (4) of his paper
    EXPECT_NEAR(std::abs(k),
                6.0 * misfit_strain * (1.0 + m) * (1.0 + m) /
                    (h * (3.0 * (1.0 + m) * (1.0 + m) + (1.0 + m * n) * (m * m + 1.0 / (m * n)))),
                1e-12);
    for (const double x : {0.05, 0.65, 1.15, 1.25, 1.55, 1.95}) {
        const double exact = (x < t1 ? E1 : E2) * (e0 + k * x) + (x < t1 ? 0.0 : E2 * misfit_strain);
        verify({.scene = fmt::format("bimetal strip with a misfit, x = {}", x),
                .source = "Timoshenko 1925",
                .quantity = "stress, MPa",
                .reference = exact,
                .ours = settled.stress_at({x, 20.05})[1],
                .within = 0.005,
                .mesh = "20 across",
                .scale = E2 * misfit_strain});
    }
}

/// A field from an Airy function that vanishes with its slope on the outline: in equilibrium as it is.
TEST(InitialStress, AFieldInEquilibriumStays) {
    Case input = steel_plate(8.0, 6.0, 0.25);
    const auto bump = [](double s, double L) { return s * s * (L - s) * (L - s) / (L * L * L * L); };
    const auto slope = [](double s, double L) { return 2.0 * s * (L - s) * (L - 2.0 * s) / (L * L * L * L); };
    const auto bend = [](double s, double L) { return 2.0 * (L * L - 6.0 * L * s + 6.0 * s * s) / (L * L * L * L); };
    StressGrid grid;
    for (int i = 0; i <= 64; ++i) grid.x.push_back(8.0 * i / 64);
    for (int i = 0; i <= 48; ++i) grid.y.push_back(6.0 * i / 48);
    for (const double y : grid.y) {
        for (const double x : grid.x) {
            grid.xx.push_back(1e4 * bump(x, 8.0) * bend(y, 6.0));
            grid.yy.push_back(1e4 * bend(x, 8.0) * bump(y, 6.0));
            grid.xy.push_back(-1e4 * slope(x, 8.0) * slope(y, 6.0));
        }
    }
    input.initial_stress = InitialStressSection{.sigma_x = {}, .sigma_y = {}, .file = {}, .grid = grid};
    const Settled settled(input);
    double off = 0.0, largest = 0.0;
    for (int e = 0; e < std::ssize(settled.scene.mesh->elements); ++e) {
        const Vec2 x = centre(*settled.scene.mesh, e);
        const Mandel given = settled.scene.initial_stress(e, x);
        off = std::max(off, (settled.stress_at(x) - given).norm());
        largest = std::max(largest, given.norm());
    }
    EXPECT_LT(off, 0.005 * largest);
}

TEST(InitialStress, KOfAnEdgeCrackIsThatOfItsWeightFunction) {
    for (const double a : {0.1, 0.2, 0.3, 0.4, 0.5}) {
        const ElasticSolution solution(EdgeCrackInAProfile::input(a));
        const double K = EdgeCrackInAProfile::weight_function_K(a);
        std::cout << fmt::format("a/W {}: K_initial {:.4f}, weight function {:.4f}\n", a, solution.tips[0].K_initial,
                                 K);
        verify({.scene = fmt::format("edge crack a/W {} in 100 (1 - 6 x + 6 x^2)", a),
                .source = "Bueckner 1970, weight function",
                .quantity = "K, MPa sqrt(mm)",
                .reference = K,
                .ours = solution.tips[0].K_initial,
                .within = 0.01,
                .mesh = fmt::format("a / {:.0f}", a / 0.005),
                .scale = 100.0 * std::sqrt(std::numbers::pi * a)});
    }
}

/// Terada (1976): a crack across a weld in a wide plate, sigma (1 - x^2/c^2) / (1 + x^4/c^4).
TEST(InitialStress, KOfACrackAcrossAWeldIsTeradas) {
    constexpr double W = 40.0, H = 160.0, c = 1.0;
    const auto weld = [](double x) { return 100.0 * (1.0 - x * x / (c * c)) / (1.0 + std::pow(x / c, 4)); };
    for (const double a : {0.5, 1.0}) {
        Case input = steel_plate(W, H, 4.0);
        input.mesh.specimen = "mt";
        input.cracks = {{.points = {{W / 2 - a, H / 2}, {W / 2 + a, H / 2}}, .contact = {}}};
        for (const double x : {W / 2 - a, W / 2 + a})
            input.mesh.grading.push_back(
                {.at = {{x, H / 2}}, .size = 0.03, .outer_size = 0.03, .radius = 0.2, .growth = 0.15});
        StressProfile profile = profile_of(0.0, W, 1200, [&](double x) { return weld(x - W / 2); });
        // The tails beyond the plate are spread over it, so that no resultant is left.
        double resultant = 0.0;
        for (std::size_t k = 0; k + 1 < profile.at.size(); ++k)
            resultant += 0.5 * (profile.stress[k] + profile.stress[k + 1]) * (profile.at[k + 1] - profile.at[k]);
        for (double& stress : profile.stress) stress -= resultant / W;
        input.initial_stress = InitialStressSection{.sigma_x = {}, .sigma_y = profile, .file = {}, .grid = {}};
        input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
        const ElasticSolution solution(input);
        const double r2 = a * a / (c * c), root = std::sqrt(1.0 + r2 * r2);
        const double unit = std::sqrt(std::numbers::pi * a);
        const double K = 100.0 * unit * std::sqrt((root - r2) / (root * root)) - resultant / W * unit;
        for (const coarse::TipResult& tip : solution.tips) {
            std::cout << fmt::format("a/c {}: K_initial {:.4f}, Terada {:.4f}\n", a / c, tip.K_initial, K);
            verify({.scene = fmt::format("crack across a weld, a/c {}", a / c),
                    .source = "Terada 1976",
                    .quantity = "K, MPa sqrt(mm)",
                    .reference = K,
                    .ours = tip.K_initial,
                    .within = 0.005,
                    .mesh = fmt::format("a / {:.0f}", a / 0.03),
                    .scale = 100.0 * unit});
        }
    }
}

/// In a linear body K, J and T of both together are those of the load plus those of the initial stress, on every ring.
TEST(InitialStress, AddsToTheLoadInAnElasticBody) {
    Case input = EdgeCrackInAProfile::input(0.3);
    input.load = {.steps = 2, .blocks = {{.cycles = 1, .max = 50.0, .min = 0.0}}};
    const RunHistory history = run_direct(input);
    const Followed& settled = history.increments.front();
    EXPECT_EQ(settled.load_factor, 0.0);
    EXPECT_NEAR(settled.work.error(), 0.0, 1e-12 * settled.work.stored);
    const coarse::TipResult& nominal = history.nominal[0];
    EXPECT_NEAR(settled.tips[0].K_I, nominal.K_initial, 1e-9 * nominal.K_initial);
    EXPECT_LT(settled.tips[0].K_spread, 3e-3);
    EXPECT_LT(settled.tips[0].J_spread, 0.02);
    const Followed& most = history.at_maximum();
    EXPECT_NEAR(most.tips[0].K_I, nominal.K_initial + 50.0 * nominal.K_I, 1e-9 * most.tips[0].K_I);
    EXPECT_NEAR(most.tips[0].J * plane_modulus, most.tips[0].K_I * most.tips[0].K_I,
                0.01 * most.tips[0].J * plane_modulus);
    EXPECT_NEAR(most.work.error(), 0.0, 1e-9 * most.work.external);
    const coarse::CycleResult& cycle = history.increments.back().cycles.at(0);
    EXPECT_NEAR(cycle.K_max, most.tips[0].K_I, 1e-9 * cycle.K_max);
    EXPECT_NEAR(cycle.K_min, nominal.K_initial, 1e-9 * cycle.K_max);
    EXPECT_EQ(cycle.K_initial, nominal.K_initial);
}

// All of it has shrunk alike, so nothing holds it: no stress is left, and K and T are that and not what the strain
// alone tells. Along a crack that bends its strain gave K of up to 1.5 % of what the stress would make: the auxiliary
// fields leave tractions on faces that are off the tip's line.
TEST(InitialStress, OfABodyThatShrinksAsAWholeLeavesNoKAndNoT) {
    const std::vector<Vec2> straight{{0.0, 2.0}, {0.3, 2.0}}, bent{{0.0, 1.95}, {0.22, 2.0}, {0.35, 2.09}};
    for (const auto& [plane, points, touches] :
         {std::tuple(PlaneState::Strain, straight, false), std::tuple(PlaneState::Stress, straight, true),
          std::tuple(PlaneState::Strain, bent, true), std::tuple(PlaneState::Stress, bent, false)}) {
        Case input = edge_crack(0.3, 4.0, End::Pulled);
        input.mesh.size = 1.0 / 21.0;
        input.model.plane = plane;
        input.cracks[0].points = points;
        if (touches) input.cracks[0].contact = ContactSection{};
        input.regions = {misfit({{-1.0, -1.0}, {2.0, 5.0}}, input.material.young, 150.0)};
        input.regions[0].material.poisson = input.material.poisson;
        input.regions[0].initial_stress->xx = 40.0;
        input.load = {.steps = 2, .blocks = {{.cycles = 1, .max = 1.0, .min = 0.0}}};
        const coarse::TipResult tip = run_direct(input).increments.front().tips[0];
        EXPECT_NEAR(tip.T_stress, 0.0, 1e-8);
        EXPECT_NEAR(tip.K_I, 0.0, 1e-8);
        EXPECT_NEAR(tip.K_II, 0.0, 1e-8);
    }
}

/// The metal of a weld is another one and yet as elastic as the plate: rings pass through both, and J is known however
/// near the crack is to where they meet.
TEST(InitialStress, AcrossMetalsOfOneElasticityJIsThatOfOne) {
    Case input = EdgeCrackInAProfile::input(0.3);
    input.load = {.steps = 2, .blocks = {{.cycles = 1, .max = 50.0, .min = 0.0}}};
    const coarse::TipResult of_one = run_direct(input).at_maximum().tips[0];
    const auto with = [&](double yy) {
        Case welded = input;
        welded.regions = {misfit({{-1.0, 2.001}, {2.0, 2.004}, {0.5, 9.0}}, input.material.young, yy)};
        welded.regions[0].material.poisson = input.material.poisson;
        return run_direct(welded).at_maximum().tips[0];
    };
    EXPECT_EQ(with(0.0).J, of_one.J);
    EXPECT_EQ(with(0.0).K_I, of_one.K_I);
    EXPECT_TRUE(std::isnan(with(1.0).J));  // of which nobody knows it across the interface
}

/// A misfit above the crack's plane, so that it slides without load: it goes on across the largest hoop stress of load
/// and stress together at the maximum, wherever in the cycle it grows.
TEST(InitialStress, TurnsACrackThatTheLoadOnlyOpens) {
    Case input = edge_crack(0.3, 4.0, End::Pulled);
    input.mesh.size = 1.0 / 21.0;
    input.regions = {misfit({{0.25, 2.05}, {0.6, 2.3}}, input.material.young, 150.0)};
    input.load = {.steps = 2, .blocks = {{.cycles = 2, .max = 50.0, .min = 0.0}}};
    for (const GrowthAt where : {GrowthAt::Maximum, GrowthAt::Minimum}) {
        input.growth = GrowthSection{.increment = 0.05, .at = where};
        const RunHistory history = run_direct(input);
        const coarse::TipResult &most = history.at_maximum().tips[0], &last = history.increments.back().tips[0];
        ASSERT_GT(std::abs(most.K_II), 0.05 * most.K_I);
        const double angle = coarse::hoop_stress_angle(most.K_I, most.K_II);
        const auto grown =
            std::ranges::find_if(history.increments, [&](const auto& i) { return i.tips[0].x > 0.3001; });
        ASSERT_NE(grown, history.increments.end());
        const coarse::TipResult& turned = grown->tips[0];
        EXPECT_NEAR(std::atan2(turned.y - 2.0, turned.x - 0.3), angle, 1e-6);
        EXPECT_LT(std::abs(last.K_II / last.K_I), 0.5 * std::abs(most.K_II / most.K_I));
    }
}

/// The band is along the crack, which does not feel it: T is what equilibrium leaves of it, and not its strain's.
TEST(InitialStress, TIsThatOfTheWholeStress) {
    for (const PlaneState plane : {PlaneState::Stress, PlaneState::Strain}) {
        Case input = specimen("plate", 40.0, {{54.0, 20.0}, {66.0, 20.0}});
        input.model.plane = plane;
        input.mesh.width = 120.0;
        input.mesh.size = 1.0;
        input.material.young = 200e3;
        input.material.poisson = 0.3;
        input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
        input.initial_stress = InitialStressSection{
            .sigma_x = profile_of(
                0.0, 40.0, 64, [](double y) { return 100.0 * std::cos(2.0 * std::numbers::pi * (y - 20.0) / 40.0); }),
            .sigma_y = {},
            .file = {},
            .grid = {}};
        input.load = {.steps = 2, .blocks = {{.cycles = 1, .max = 1.0, .min = 0.0}}};
        const double T = run_direct(input).increments.front().tips[0].T_stress;
        Case whole = input;
        whole.cracks.clear();
        const Mandel there = Settled(whole).stress_at({66.0, 20.0});
        EXPECT_NEAR(T, there[0] - there[1], 1.0) << there.transpose();
    }
}

/// The load factor follows though no load moves the body to where it is at first.
TEST(InitialStress, LeavesDisplacementToBeControlled) {
    Case input = steel_plate(4.0, 6.0, 1.0);
    input.model.plane = PlaneState::Stress;
    input.material.poisson = 0.0;
    input.regions = {misfit({{1.0, 0.0}, {3.0, 6.0}}, 200e3, 120.0)};
    input.boundaries = {at_end("top", End::Pulled, 1.0), moved("bottom", {}, 0.0), moved("point", 0.0, {})};
    input.boundaries[2].at = Vec2(0.0, 0.0);
    input.load = {.steps = 8, .blocks = {{.cycles = 1, .max = 1e-3, .min = 0.0}}};
    input.load.control = Control::Displacement;
    const RunHistory history = run_direct(input);
    // Free of load the strip is shorter by 6 mm 120 / 2 / 200e3 = 0.0018 mm.
    EXPECT_NEAR(history.at_maximum().machine.displacement, 1e-3, 1e-12);
    EXPECT_NEAR(history.at_maximum().load_factor, (1e-3 + 1.8e-3) / 6.0 * 200e3, 1e-6);
}

/// Stress that no equilibrium could be in, or that leaves nothing.
TEST(InitialStress, WhatIsNotSelfEquilibratedIsRefused) {
    Case input = EdgeCrackInAProfile::input(0.3);
    const auto complaint = [&] { return refusal_of([&] { return run_direct(input); }); };
    input.load = {.steps = 2, .blocks = {{.cycles = 0, .max = 1.0, .min = 0.0}}};
    EXPECT_EQ(complaint(), "accepted");
    StressProfile& profile = *input.initial_stress->sigma_y;
    const StressProfile good = profile;
    for (double& stress : profile.stress) stress += 10.0;
    EXPECT_NE(complaint().find("initial_stress.sigma_y: has a resultant of 10.06 N/mm"), std::string::npos)
        << complaint();
    profile = good;
    profile.at.back() = 0.9;
    EXPECT_NE(complaint().find("must cover the body"), std::string::npos);
    StressGrid grid{.x = {0.0, 1.0}, .y = {0.0, 4.0}, .xx = {}, .yy = {}, .xy = {}};
    grid.xx = grid.xy = {0.0, 0.0, 0.0, 0.0};
    grid.yy = {50.0, -50.0, 50.0, -50.0};  // bends, and bends away
    input.initial_stress = InitialStressSection{.sigma_x = {}, .sigma_y = {}, .file = {}, .grid = grid};
    EXPECT_NE(complaint().find("not self-equilibrated"), std::string::npos) << complaint();
}

}  // namespace
}  // namespace stria::test
