// Newton's method on one scalar equation: convergence, both of its tests, failure.
#include "coarse/equilibrium/newton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "common/error.hpp"

namespace stria::coarse {
namespace {

/// A spring with the force f(u), pulled by the load factor. `scale`: of its residual.
class Spring : public Equilibrium {
public:
    std::function<double(double)> force = [](double x) { return x + x * x * x; };
    std::function<double(double)> stiffness = [](double x) { return 1.0 + 3.0 * x * x; };
    double scale = 1.0, interior = 0.0, contact = 0.0;
    double u = 0.0, start = 0.0;
    int applied = 0, parts = 0, looked = 0, provisional = 0;  // states that are
    int wakes_at = -1;                                        // number of the state, from 0
    int closed = 0;                                           // multipliers
    std::vector<int> changes;                                 // of status, of the states to come
    bool elastic = false;
    int elastic_states = 0;
    int yielding = 0, begun_apart = 0;
    bool parts_slowly = false;  // unless it begins apart: no state balances
    bool inside = false;        // its residual is one of the zone's
    double condensed = 1.0;     // what condensing makes of it

    void begin(const Target& target, const Predictor& predictor) override {
        load_ = target.value;
        u = start + predictor.factor;
        begun_apart += predictor.apart ? 1 : 0;
    }
    Residual linearise() override {
        residual_ = load_ - force(u);
        if (parts_slowly && begun_apart == 0) residual_ = 1.0;
        elastic_states += elastic ? 1 : 0;
        return {.boundary = condensed * std::abs(residual_),
                .nodal = std::abs(residual_),
                .interior = inside ? std::abs(residual_) : interior,
                .contact = contact,
                .scale = scale,
                .along = residual_ * correction_,
                .along_before = before_,
                .yielding_points = yielding,
                .closed = closed,
                .status_changes = next_changes(),
                .provisional = provisional-- > 0,
                .woken = wakes_at-- == 0};
    }
    double solve() override {
        correction_ = residual_ / stiffness(u);
        return std::abs(correction_) / std::max(std::abs(u), 1e-300);
    }
    void look_at_rest() override { ++looked; }
    void set_elastic(bool is) override { elastic = is; }
    void apply() override {
        before_ = residual_ * correction_;
        u += correction_;
        ++applied;
    }
    void apply_further(double part) override {
        u += part * correction_;
        ++parts;
    }
    void put_aside() override {}
    coupling::StepReport commit(const coupling::Commit&) override { return {}; }
    void rollback() override {}
    [[nodiscard]] LoadFactors factors() const override { return load_; }
    [[nodiscard]] const std::vector<std::int32_t>& yielding_points() const override { return none_; }
    [[nodiscard]] Eigen::VectorXd structure_displacement() const override { return {}; }
    [[nodiscard]] const Eigen::VectorXd& near_displacement() const override { return nothing_; }
    [[nodiscard]] MachineReading machine_reading() const override { return {}; }
    [[nodiscard]] EquilibriumState state() const override { return {}; }
    void restore(const EquilibriumState&) override {}

private:
    int next_changes() {
        if (changes.empty()) return 0;
        const int first = changes.front();
        changes.erase(changes.begin());
        return first;
    }

    std::vector<std::int32_t> none_;
    double load_ = 0.0, residual_ = 0.0, correction_ = 0.0, before_ = 0.0;
    Eigen::VectorXd nothing_;
};

const SolverSection solver{.tolerance = 1e-10, .max_iterations = 12, .max_cuts = 8};

TEST(Newton, ConvergesQuadratically) {
    Spring spring;
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 0.6, solver);
    ASSERT_TRUE(report.converged);
    EXPECT_NEAR(spring.u, 1.0, 1e-10);
    for (std::size_t k = 2; k < report.iterations.size(); ++k) {
        const double before = report.iterations[k - 1].residual.boundary;
        EXPECT_LT(report.iterations[k].residual.boundary, before * before);  // f''/(2 f'^2) = 3/16 at the root
    }
}

TEST(Newton, StartsFromThePredictedState) {
    Spring spring;
    spring.start = 0.25;
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 0.75, solver);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.count(), 1);
    EXPECT_EQ(spring.applied, 0);  // what is converged is not moved
}

TEST(Newton, BeginsAgainWhereTheGuessMisleads) {
    Spring spring;
    // Beyond u = 2 of the wrong sign: from there Newton's method runs away.
    spring.stiffness = [](double u) { return (u > 2.0 ? -1.0 : 1.0) * (1.0 + 3.0 * u * u); };
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 3.0, solver);
    ASSERT_TRUE(report.converged);
    EXPECT_TRUE(report.was_misled());
    EXPECT_EQ(report.lost.size(), 4U);
    EXPECT_EQ(report.count(), static_cast<int>(report.lost.size() + report.iterations.size()));
    EXPECT_NEAR(spring.u, 1.0, 1e-10);
    EXPECT_FALSE(find_equilibrium(spring, {Control::Load, 2.0}, 0.6, solver).was_misled());
}

// A fifth nearer in each iteration: no start that misleads by its fourth state, and none that leads there in time.
TEST(Newton, BeginsAgainWhereTheGuessDoesNotConverge) {
    Spring spring;
    spring.scale = 100.0;
    spring.force = [](double u) { return u <= 1.0 ? 2.0 * u : 2.0 + std::pow(u - 1.0, 5); };
    spring.stiffness = [](double u) { return u <= 1.0 ? 2.0 : 5.0 * std::pow(u - 1.0, 4); };
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 3.0, solver);
    ASSERT_TRUE(report.converged) << report.table();
    EXPECT_EQ(report.lost.size(), solver.max_iterations + 1U);
    EXPECT_TRUE(report.failure.empty());
    spring.start = 3.0;
    EXPECT_FALSE(find_equilibrium(spring, {Control::Load, 2.0}, 3.0, solver).converged);
}

// Faces of slender arms part one by one, at any load: halving would help nothing.
TEST(Newton, BeginsOnceMoreFromOpenFacesWhereThoseOfElasticMetalGoOnChanging) {
    const auto from = [](int yielding, int changes, double held) {
        Spring spring;
        spring.parts_slowly = true;
        spring.yielding = yielding;
        spring.changes = {0, 0, 0, 0, changes};
        const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0, held}, {}, solver);
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
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, {}, solver);
    EXPECT_EQ(spring.begun_apart, 1);
    EXPECT_EQ(report.failure, "no convergence in 12 iterations (solver.max_iterations)");
}

// Of the same states condensing says more, by how much they are out of balance inside: as all modes do, so does it.
TEST(Newton, JudgesAGuessByWhatTheNodesFeel) {
    Spring spring;
    spring.scale = 1e5;
    SolverSection patient = solver;
    patient.max_iterations = 20;
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 40.0, patient);
    EXPECT_FALSE(report.was_misled());
    const double fourth = report.iterations.at(3).residual.nodal;
    EXPECT_LT(fourth, 1e4) << "a tenth of the forces";
    Spring condensed;
    condensed.scale = spring.scale;
    condensed.condensed = 2e4 / fourth;
    const NewtonReport same = find_equilibrium(condensed, {Control::Load, 2.0}, 40.0, patient);
    EXPECT_FALSE(same.was_misled());
    EXPECT_EQ(same.count(), report.count());
}

TEST(Newton, BeginsAgainWhereTheGuessCannotBeEvaluated) {
    Spring spring;
    spring.force = [](double u) {
        if (u > 2.0) throw NumericalFailure("too far");
        return u + u * u * u;
    };
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 3.0, solver);
    EXPECT_TRUE(report.converged);
    EXPECT_TRUE(report.failure.empty());
    spring.start = 3.0;
    EXPECT_EQ(find_equilibrium(spring, {Control::Load, 2.0}, 3.0, solver).failure, "too far");
}

TEST(Newton, AsksForASmallResidual) {
    Spring spring;
    spring.force = [](double u) { return 1e9 * (u - 1.0); };  // stiff: a small correction proves nothing
    spring.stiffness = [](double) { return 1.05e9; };
    spring.start = 0.9;
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 0.0}, 0.0, solver);
    ASSERT_TRUE(report.converged);
    EXPECT_LT(report.iterations.back().residual.boundary, 1e-10);
    EXPECT_LT(report.iterations[report.iterations.size() - 2].correction, 1e-8);
}

TEST(Newton, AsksForASmallCorrection) {
    Spring spring;
    spring.force = [](double u) { return 1e-12 * u * u; };  // soft: a small residual proves nothing
    spring.stiffness = [](double u) { return 2e-12 * u; };
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 4e-12}, 1.0, solver);
    ASSERT_TRUE(report.converged);
    EXPECT_LT(report.iterations.front().residual.boundary, 1e-10);
    EXPECT_NEAR(spring.u, 2.0, 1e-8);
}

TEST(Newton, AsksForAllThreeResiduals) {
    for (const auto& [interior, contact] : {std::pair{1e-3, 0.0}, {0.0, 1e-3}}) {
        Spring spring;
        spring.interior = interior;
        spring.contact = contact;
        EXPECT_FALSE(find_equilibrium(spring, {Control::Load, 2.0}, 0.0, solver).converged);
    }
}

TEST(Newton, StopsWhereNobodyWaitsAnyMore) {
    Spring spring;
    spring.interior = 1e-3;  // never settles
    SolverSection patient = solver;
    patient.max_iterations = 10'000;
    int asked = 0;
    const NewtonReport report =
        find_equilibrium(spring, {Control::Load, 2.0}, 0.0, patient, 0.0, [&] { return ++asked <= 30; });
    EXPECT_TRUE(report.stopped);
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.count(), 30);
}

TEST(Newton, GoesOnFromAStateThatIsProvisional) {
    Spring spring, sure;
    spring.provisional = 7;
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 2.0}, 0.6, solver);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations.size(), 8U);
    EXPECT_GT(spring.looked, 0);
    EXPECT_LT(find_equilibrium(sure, {Control::Load, 2.0}, 0.6, solver).iterations.size(), 8U);
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
        const NewtonReport report = find_equilibrium(spring, {Control::Load, 1.0}, 0.0, rough);
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
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 1e-4}, 0.0, solver);
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
    EXPECT_FALSE(find_equilibrium(spring, {Control::Load, 1e-6}, 0.0, coarse_solver).converged);
}

// From a flat branch to the other one, and back for ever: between them it is steep.
TEST(Newton, GivesBackStepsThatGoToAndFro) {
    Spring spring;
    spring.force = [](double u) { return std::clamp(10.0 * u, -1.0, 1.0) + 0.01 * u; };
    spring.stiffness = [](double u) { return std::abs(u) < 0.1 ? 10.01 : 0.01; };
    spring.start = 0.2;
    spring.inside = true;
    EXPECT_TRUE(find_equilibrium(spring, {Control::Load, 0.5}, 0.0, solver).converged);
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
        EXPECT_TRUE(find_equilibrium(spring, {Control::Load, 2.0, held}, start, solver).converged);
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
    EXPECT_TRUE(find_equilibrium(spring, {Control::Load, 1.0}, {}, solver).converged);
    EXPECT_NEAR(spring.u, 2.0, 1e-10);
    EXPECT_FALSE(spring.elastic);
    Spring rests;
    rests.closed = 1;
    rests.start = 1.0;
    EXPECT_EQ(find_equilibrium(rests, {Control::Load, 2.0}, {}, solver).count(), 1);
}

TEST(Newton, MeasuresResidualsByTheForceScale) {
    Spring spring;
    spring.scale = 1e9;
    spring.interior = 1e-3;
    EXPECT_TRUE(find_equilibrium(spring, {Control::Load, 2.0}, 0.6, solver).converged);
}

// Nothing balances at no load, and rounding is all there is: what is that small beside forces of before is at rest.
TEST(Newton, WithoutLoadAsksForNoLessThanRounding) {
    Spring spring;
    spring.force = [](double u) { return u; };
    spring.stiffness = [](double) { return 1.0; };
    spring.interior = spring.scale = 1e-15;  // of forces of 100 that were
    EXPECT_FALSE(find_equilibrium(spring, {Control::Load, 0.0}, 0.0, solver).converged);
    EXPECT_TRUE(find_equilibrium(spring, {Control::Load, 0.0}, 0.0, solver, 100.0).converged);
    spring.interior = 1e-10;
    EXPECT_FALSE(find_equilibrium(spring, {Control::Load, 0.0}, 0.0, solver, 100.0).converged);
}

TEST(Newton, ReportsThatItDidNotConverge) {
    Spring spring;
    spring.force = [](double u) { return 1.0 + u * u; };  // it never goes down to zero
    spring.stiffness = [](double u) { return 2.0 * u; };
    spring.start = 1.1;
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 0.0}, 0.0, solver);
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.failure, "no convergence in 12 iterations (solver.max_iterations)");
    EXPECT_EQ(report.count(), 13);
}

TEST(Newton, ReportsWhatFailedOnTheOtherSide) {
    Spring spring;
    spring.force = [](double) -> double { throw NumericalFailure("a spring broke"); };
    const NewtonReport report = find_equilibrium(spring, {Control::Load, 1.0}, 0.0, solver);
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.failure, "a spring broke");
}

TEST(Newton, AResidualThatIsNoNumberFails) {
    Spring spring;
    spring.force = [](double) { return std::nan(""); };
    EXPECT_EQ(find_equilibrium(spring, {Control::Load, 1.0}, 0.0, solver).failure, "the residual is not a number");
}

TEST(Newton, OurOwnMistakesAreNotItsFailures) {
    Spring spring;
    spring.force = [](double) -> double { throw std::logic_error("a bug"); };
    EXPECT_THROW(find_equilibrium(spring, {Control::Load, 1.0}, 0.0, solver), std::logic_error);
}

}  // namespace
}  // namespace stria::coarse
