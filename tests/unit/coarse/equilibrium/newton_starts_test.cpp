// Where Newton's method begins, and begins again: guesses that help, mislead or lead nowhere.
#include "coarse/equilibrium/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/error.hpp"
#include "tests/support/spring.hpp"

namespace stria::coarse {
namespace {

TEST(Newton, StartsFromThePredictedState) {
    Spring spring;
    spring.start = 0.25;
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 0.75, {solver});
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.count(), 1);
    EXPECT_EQ(spring.applied, 0);  // what is converged is not moved
}

TEST(Newton, BeginsAgainWhereTheGuessMisleads) {
    Spring spring;
    // Beyond u = 2 of the wrong sign: from there Newton's method runs away.
    spring.stiffness = [](double u) { return (u > 2.0 ? -1.0 : 1.0) * (1.0 + 3.0 * u * u); };
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 3.0, {solver});
    ASSERT_TRUE(report.converged);
    EXPECT_TRUE(report.was_misled());
    EXPECT_EQ(report.lost.size(), 4U);
    EXPECT_EQ(report.count(), static_cast<int>(report.lost.size() + report.iterations.size()));
    EXPECT_NEAR(spring.u, 1.0, 1e-10);
    EXPECT_FALSE(find_equilibrium(spring, {Control::Load, 2.0}, 0.6, {solver}).was_misled());
}

// A fifth nearer in each iteration: no start that misleads by its fourth state, and none that leads there in time.
TEST(Newton, BeginsAgainWhereTheGuessDoesNotConverge) {
    Spring spring;
    spring.scale = 100.0;
    spring.force = [](double u) { return u <= 1.0 ? 2.0 * u : 2.0 + std::pow(u - 1.0, 5); };
    spring.stiffness = [](double u) { return u <= 1.0 ? 2.0 : 5.0 * std::pow(u - 1.0, 4); };
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 3.0, {solver});
    ASSERT_TRUE(report.converged) << report.table();
    EXPECT_EQ(report.lost.size(), solver.max_iterations + 1U);
    EXPECT_TRUE(report.failure.empty());
    spring.start = 3.0;
    EXPECT_FALSE(find_equilibrium(spring, {Control::Load, 2.0}, 3.0, {solver}).converged);
}

// Faces of slender arms part one by one, at any load: halving would help nothing.
TEST(Newton, BeginsOnceMoreFromOpenFacesWhereThoseOfElasticMetalGoOnChanging) {
    const auto from = [](int yielding, int changes, double held) {
        Spring spring;
        spring.parts_slowly = true;
        spring.yielding = yielding;
        spring.changes = {0, 0, 0, 0, changes};
        const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0, held}, {}, {solver});
        EXPECT_EQ(report.converged, spring.begun_apart == 1);
        EXPECT_EQ(report.failure.empty(), report.converged);
        EXPECT_EQ(report.lost.empty(), !report.converged);
        return report.converged;
    };
    EXPECT_TRUE(from(0, 1, 0.0));
    EXPECT_FALSE(from(1, 1, 0.0)) << "a smaller load lets less flow";
    EXPECT_FALSE(from(0, 0, 0.0)) << "no face changes";
    EXPECT_FALSE(from(0, 1, 0.5)) << "faces that growth opens";
}

TEST(Newton, FromOpenFacesThatLeadNowhereEitherItSaysWhyItFailedBefore) {
    Spring spring;
    spring.parts_slowly = true;
    spring.changes = {0, 0, 0, 0, 1};
    spring.force = [&](double) { return spring.begun_apart > 0 ? NAN : 0.0; };
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, {}, {solver});
    EXPECT_EQ(spring.begun_apart, 1);
    EXPECT_EQ(report.failure, "no convergence in 12 iterations (solver.max_iterations)");
}

// Of the same states condensing says more, by how much they are out of balance inside: as all modes do, so does it.
TEST(Newton, JudgesAGuessByWhatTheNodesFeel) {
    Spring spring;
    spring.scale = 1e5;
    SolverSection patient = solver;
    patient.max_iterations = 20;
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 40.0, {patient});
    EXPECT_FALSE(report.was_misled());
    const double fourth = report.iterations.at(3).residual.nodal;
    EXPECT_LT(fourth, 1e4) << "a tenth of the forces";
    Spring condensed;
    condensed.scale = spring.scale;
    condensed.condensed = 2e4 / fourth;
    const NewtonReport same = find_equilibrium(condensed, {Control::Load, 2.0}, 40.0, {patient});
    EXPECT_FALSE(same.was_misled());
    EXPECT_EQ(same.count(), report.count());
}

TEST(Newton, BeginsAgainWhereTheGuessCannotBeEvaluated) {
    Spring spring;
    spring.force = [](double u) {
        if (u > 2.0) throw NumericalFailure("too far");
        return u + u * u * u;
    };
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 3.0, {solver});
    EXPECT_TRUE(report.converged);
    EXPECT_TRUE(report.failure.empty());
    spring.start = 3.0;
    EXPECT_EQ(find_equilibrium(spring, {Control::Load, 2.0}, 3.0, {solver}).failure, "too far");
}

}  // namespace
}  // namespace stria::coarse
