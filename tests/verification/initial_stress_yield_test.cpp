// Faces and metal under a stress that was there before any load: what opens, and what yields, by the sum of both.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/initial_stresses.hpp"
#include "tests/support/layered_plates.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

/// Pressed by the stress that is left in it, an elastic crack opens where load and stress together have K = 0 at its
/// tip.
TEST(InitialStress, ACompressedCrackOpensLater) {
    Case input = EdgeCrackInAProfile::input(0.3);
    for (double& stress : input.initial_stress->sigma_y->stress) stress = -stress;
    input.cracks[0].contact = ContactSection{};
    input.closure.distance = 0.002;
    input.load = {.steps = 16, .blocks = {{.cycles = 1, .max = 100.0, .min = 0.0}}};
    const RunHistory history = run_direct(input);
    EXPECT_GT(history.increments.front().zone.contact_length[0], 0.1);
    const coarse::CycleResult& cycle = history.increments.back().cycles.at(0);
    EXPECT_LT(cycle.K_initial, 0.0);
    EXPECT_GT(cycle.opening.K_op, cycle.K_min);
    EXPECT_LT(cycle.opening.K_op, cycle.K_max);
    EXPECT_NEAR(history.at_maximum().tips[0].K_I, cycle.K_max, 1e-3 * cycle.K_max);
}

/// A strip between rigid ends holds all of its misfit: it yields where load and misfit together reach its yield stress.
TEST(InitialStress, YieldSeesTheWhole) {
    Case input = steel_plate(4.0, 6.0, 1.0);
    input.model.plane = PlaneState::Stress;
    input.material.poisson = 0.0;
    input.material.yield_stress = 300.0;
    input.regions = {misfit({{3.0, 0.0}, {4.0, 6.0}}, 200e3, 120.0)};
    input.regions[0].material.yield_stress = 300.0;
    input.boundaries = {moved("bottom", {}, 0.0), moved("top", {}, 1.0), moved("point", 0.0, {})};
    input.boundaries[2].at = Vec2(0.0, 0.0);
    input.solver.tolerance = 1e-10;
    const auto dissipated_at = [&](double strain) {
        input.load = {.steps = 80, .blocks = {{.cycles = 0, .max = 6.0 * strain, .min = 0.0}}};
        const RunHistory history = run_direct(input);
        const Followed &first = history.increments.front(), &last = history.increments.back();
        EXPECT_NEAR(first.machine.force, 120.0, 1e-9 * 120.0);
        EXPECT_NEAR(first.work.stored, 6.0 * 120.0 * 120.0 / (2.0 * 200e3), 1e-9);
        EXPECT_NEAR(last.machine.force, 3.0 * 200e3 * strain + std::min(300.0, 200e3 * strain + 120.0), 1e-6);
        EXPECT_NEAR(last.work.error(), 0.0, 1e-3 * last.work.external);
        return last.work.dissipated;
    };
    EXPECT_EQ(dissipated_at(0.00089), 0.0);
    EXPECT_NEAR(dissipated_at(0.0012), 6.0 * 300.0 * 0.0003, 1e-4 * 0.54);
}

/// A film with twice its yield stress between rigid ends: 200 - E p = 100 + H p. No increment comes to the yield
/// surface from within.
TEST(InitialStress, BeyondYieldFlowsAtOnce) {
    const double E = 200e3, H = 20e3, p = (200.0 - 100.0) / (E + H);
    for (const PlaneState plane : {PlaneState::Stress, PlaneState::Strain}) {
        for (const bool straight : {true, false}) {
            Case input = steel_plate(4.0, 6.0, 1.0);
            input.model.plane = plane;
            input.material.poisson = 0.0;
            input.regions = {misfit({{2.0, 0.0}, {3.0, 6.0}}, E, 200.0)};
            MaterialSection& film = input.regions[0].material;
            film.yield_stress = 100.0;
            if (straight)
                film.isotropic.modulus = H;
            else
                film.isotropic = {
                    .law = HardeningLaw::Table, .plastic_strain = {0.0, 1.0}, .stress = {100.0, 100.0 + H}};
            input.boundaries = {moved("bottom", {}, 0.0), moved("top", {}, 1.0), moved("point", 0.0, {})};
            input.boundaries[2].at = Vec2(0.0, 0.0);
            input.load = {.steps = 2, .blocks = {{.cycles = 0, .max = -1e-9, .min = 0.0}}};
            input.solver.tolerance = 1e-10;
            const Followed first = run_direct(input).increments.front();
            // In plane strain the film flows across the plane, too, which poisson = 0 leaves to flow alone.
            if (plane == PlaneState::Stress) {
                EXPECT_NEAR(first.machine.force, 100.0 + H * p, 1e-5);
                EXPECT_NEAR(first.work.dissipated, 6.0 * 100.0 * p, 1e-6);
            } else {
                EXPECT_LT(first.machine.force, 130.0);
                EXPECT_GT(first.work.dissipated, 0.0);
            }
        }
    }
}

}  // namespace
}  // namespace stria::test
