// Newton's method on one scalar equation: convergence, both of its tests, failure.
#include "coarse/equilibrium/newton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "tests/support/spring.hpp"

namespace stria::coarse {
namespace {

TEST(Newton, ConvergesQuadratically) {
    Spring spring;
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 0.6, {solver});
    ASSERT_TRUE(report.converged);
    EXPECT_NEAR(spring.u, 1.0, 1e-10);
    for (std::size_t k = 2; k < report.iterations.size(); ++k) {
        const double before = report.iterations[k - 1].residual.boundary;
        EXPECT_LT(report.iterations[k].residual.boundary, before * before);  // f''/(2 f'^2) = 3/16 at the root
    }
}

TEST(Newton, AsksForASmallResidual) {
    Spring spring;
    spring.force = [](double u) { return 1e9 * (u - 1.0); };  // stiff: a small correction proves nothing
    spring.stiffness = [](double) { return 1.05e9; };
    spring.start = 0.9;
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 0.0}, 0.0, {solver});
    ASSERT_TRUE(report.converged);
    EXPECT_LT(report.iterations.back().residual.boundary, 1e-10);
    EXPECT_LT(report.iterations[report.iterations.size() - 2].correction, 1e-8);
}

TEST(Newton, AsksForASmallCorrection) {
    Spring spring;
    spring.force = [](double u) { return 1e-12 * u * u; };  // soft: a small residual proves nothing
    spring.stiffness = [](double u) { return 2e-12 * u; };
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 4e-12}, 1.0, {solver});
    ASSERT_TRUE(report.converged);
    EXPECT_LT(report.iterations.front().residual.boundary, 1e-10);
    EXPECT_NEAR(spring.u, 2.0, 1e-8);
}

TEST(Newton, AsksForAllThreeResiduals) {
    for (const auto& [interior, contact] : {std::pair{1e-3, 0.0}, {0.0, 1e-3}}) {
        Spring spring;
        spring.interior = interior;
        spring.contact = contact;
        EXPECT_FALSE(find_equilibrium(spring, {Control::Load, 2.0}, 0.0, {solver}).converged);
    }
}

TEST(Newton, StopsWhereNobodyWaitsAnyMore) {
    Spring spring;
    spring.interior = 1e-3;  // never settles
    SolverSection patient = solver;
    patient.max_iterations = 10'000;
    int asked = 0;
    const NewtonReport report =
        find_equilibrium(spring, {Control::Load, 2.0}, 0.0, {patient, 0.0, [&] { return ++asked <= 30; }});
    EXPECT_TRUE(report.stopped);
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.count(), 30);
}

TEST(Newton, GoesOnFromAStateThatIsProvisional) {
    Spring spring, sure;
    spring.provisional = 7;
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 0.6, {solver});
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations.size(), 8U);
    EXPECT_GT(spring.looked, 0);
    EXPECT_LT(find_equilibrium(sure, {Control::Load, 2.0}, 0.6, {solver}).iterations.size(), 8U);
}

// 12 iterations are allowed.
TEST(Newton, HasAsManyIterationsAgainOnceElementsAreWoken) {
    for (const bool wakes : {false, true}) {
        Spring spring;
        spring.force = [](double u) { return u; };
        spring.stiffness = [](double) { return 2.0; };  // gains a bit per iteration
        spring.wakes_at = wakes ? 7 : -1;
        SolverSection rough = solver;
        rough.tolerance = 1e-5;
        const NewtonReport report = find_equilibrium(spring, {Control::Load, 1.0}, 0.0, {rough});
        EXPECT_EQ(report.converged, wakes);
        EXPECT_EQ(report.count(), wakes ? 18 : 13);  // 2^-17 < 1e-5
    }
}

// Next to a limit load: forces to rounding, and displacements to that over the stiffness.
TEST(Newton, SettlesWhereOnlyRoundingIsLeftOfTheCorrection) {
    Spring spring;
    int call = 0;
    spring.force = [&](double u) { return 1e-7 * (u - 1.0) + (call++ % 2 == 0 ? 1e-12 : -1e-12); };
    spring.stiffness = [](double) { return 1e-7; };
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 1e-4}, 0.0, {solver});
    EXPECT_TRUE(report.converged);
    EXPECT_LT(report.count(), 6);
    EXPECT_NEAR(spring.u, 1001.0, 2e-5);
}

// What is left is within a coarse tolerance, but no rounding: where the spring stands is not known.
TEST(Newton, DoesNotTakeForRoundingWhatATolerancePermits) {
    Spring spring;
    int call = 0;
    spring.force = [&](double u) { return 1e-7 * (u - 1.0) + (call++ % 2 == 0 ? 1e-7 : -1e-7); };
    spring.stiffness = [](double) { return 1e-7; };
    SolverSection coarse_solver = solver;
    coarse_solver.tolerance = 1e-5;
    EXPECT_FALSE(find_equilibrium(spring, {Control::Load, 1e-6}, 0.0, {coarse_solver}).converged);
}

// From a flat branch to the other one, and back for ever: between them it is steep.
TEST(Newton, GivesBackStepsThatGoToAndFro) {
    Spring spring;
    spring.force = [](double u) { return std::clamp(10.0 * u, -1.0, 1.0) + 0.01 * u; };
    spring.stiffness = [](double u) { return std::abs(u) < 0.1 ? 10.01 : 0.01; };
    spring.start = 0.2;
    spring.inside = true;
    EXPECT_TRUE(find_equilibrium(spring, {Control::Load, 0.5}, 0.0, {solver}).converged);
    EXPECT_NEAR(spring.u, 0.5 / 10.01, 1e-8);
    EXPECT_GT(spring.parts, 0);
}

// Where faces change that nobody predicts, the state is evaluated again, with metal that may not flow, until none of
// them changes.
TEST(Newton, LetsFacesComeToRestBeforeMetalFlows) {
    const auto elastic = [](const Predictor& start, int closed, std::vector<int> changes, double held = 0.0) {
        Spring spring;
        spring.closed = closed;
        spring.changes = std::move(changes);
        EXPECT_TRUE(find_equilibrium(spring, {Control::Load, 2.0, held}, start, {solver}).converged);
        EXPECT_NEAR(spring.u, 1.0, 1e-10);
        return spring.elastic_states;
    };
    EXPECT_EQ(elastic({}, 2, {0, 1, 0, 3, 0}), 3);
    EXPECT_EQ(elastic({}, 2, {0, 1, 0, 0}), 2);
    EXPECT_EQ(elastic({}, 2, {0, 0, 1}), 0) << "none changes at first";
    EXPECT_EQ(elastic({}, 0, {0, 1, 1}), 0) << "all is open";
    EXPECT_EQ(elastic(0.6, 2, {0, 1, 1}), 0) << "as a cycle ago";
    EXPECT_EQ(elastic({}, 2, {0, 1, 1}, 1.0), 0) << "new faces part";
    EXPECT_EQ(elastic({}, 2, std::vector<int>(9, 1)), 6) << "not for ever";
}

// What is elastic by order is no equilibrium; what is one from the start takes no iteration.
TEST(Newton, AcceptsNoStateInWhichMetalMayNotFlow) {
    Spring spring;
    spring.closed = 1;
    spring.changes = {0, 1, 0, 1, 1, 1, 0};
    spring.force = [&](double u) { return spring.elastic ? u : 0.5 * u; };
    spring.stiffness = [&](double) { return spring.elastic ? 1.0 : 0.5; };
    EXPECT_TRUE(find_equilibrium(spring, {Control::Load, 1.0}, {}, {solver}).converged);
    EXPECT_NEAR(spring.u, 2.0, 1e-10);
    EXPECT_FALSE(spring.elastic);
    Spring rests;
    rests.closed = 1;
    rests.start = 1.0;
    EXPECT_EQ(find_equilibrium(rests, {Control::Load, 2.0}, {}, {solver}).count(), 1);
}

TEST(Newton, MeasuresResidualsByTheForceScale) {
    Spring spring;
    spring.scale = 1e9;
    spring.interior = 1e-3;
    EXPECT_TRUE(find_equilibrium(spring, {Control::Load, 2.0}, 0.6, {solver}).converged);
}

// Nothing balances at no load, and rounding is all there is: what is that small beside forces of before is at rest.
TEST(Newton, WithoutLoadAsksForNoLessThanRounding) {
    Spring spring;
    spring.force = [](double u) { return u; };
    spring.stiffness = [](double) { return 1.0; };
    spring.interior = spring.scale = 1e-15;  // of forces of 100 that were
    EXPECT_FALSE(find_equilibrium(spring, {Control::Load, 0.0}, 0.0, {solver}).converged);
    EXPECT_TRUE(find_equilibrium(spring, {Control::Load, 0.0}, 0.0, {solver, 100.0}).converged);
    spring.interior = 1e-10;
    EXPECT_FALSE(find_equilibrium(spring, {Control::Load, 0.0}, 0.0, {solver, 100.0}).converged);
}

TEST(Newton, ReportsThatItDidNotConverge) {
    Spring spring;
    spring.force = [](double u) { return 1.0 + u * u; };  // it never goes down to zero
    spring.stiffness = [](double u) { return 2.0 * u; };
    spring.start = 1.1;
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 0.0}, 0.0, {solver});
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.failure, "no convergence in 12 iterations (solver.max_iterations)");
    EXPECT_EQ(report.count(), 13);
}

TEST(Newton, ReportsWhatFailedOnTheOtherSide) {
    Spring spring;
    spring.force = [](double) -> double { throw NumericalFailure("a spring broke"); };
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 1.0}, 0.0, {solver});
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.failure, "a spring broke");
}

TEST(Newton, AResidualThatIsNoNumberFails) {
    Spring spring;
    spring.force = [](double) { return std::nan(""); };
    EXPECT_EQ(find_equilibrium(spring, {Control::Load, 1.0}, 0.0, {solver}).failure, "the residual is not a number");
}

TEST(Newton, OurOwnMistakesAreNotItsFailures) {
    Spring spring;
    spring.force = [](double) -> double { throw std::logic_error("a bug"); };
    EXPECT_THROW(find_equilibrium(spring, {Control::Load, 1.0}, 0.0, {solver}), std::logic_error);
}

}  // namespace
}  // namespace stria::coarse
