// What rests of a zone: the same displacements and forces as awake, woken where it would yield; faces too.
#include "fine/zone/fine_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/pulled_zone.hpp"

namespace stria::test {
namespace {

using coupling::PatchResponse;
using fine::FineModel;

/// A plate whose crack sees little of it: after a whole cycle most of it rests.
class Resting : public testing::Test {
protected:
    explicit Resting(const Case& input = plate_case({mouth_of_pulled, tip_of_pulled}), int columns = 11)
        : mesh_(plate_mesh(columns, 9, input)), model_(input), full_(zone_, input) {}

    /// Both to equilibrium, and committed.
    coupling::StepReport go_to(double strain, bool reversal) {
        const Eigen::VectorXd boundary = stretched(zone_, strain);
        const auto settled_whole = [](const PatchResponse& r) {
            return r.interior_residual + r.contact_residual < 1e-11 * r.interior_force;
        };
        PatchResponse condensed, whole;
        for (int iteration = 0; iteration < 40; ++iteration) {
            model_.request({.iteration = iteration, .boundary = boundary});
            condensed = model_.collect();
            whole = iteration == 0 ? full_.begin(boundary, {}) : full_.iterate(boundary);
            if (iteration > 2 && settled_whole(condensed) && settled_whole(whole)) break;
        }
        EXPECT_LT((condensed.force - full_.force()).lpNorm<Eigen::Infinity>(), 1e-9 * condensed.interior_force);
        coupling::StepReport report = model_.commit({.reversal = reversal});
        full_.commit({.reversal = reversal});
        const Eigen::VectorXd difference = model_.state().displacement - full_.displacement();
        EXPECT_LT(difference.lpNorm<Eigen::Infinity>(), 1e-11) << strain;
        return report;
    }

    /// Between nothing and a peak, in increments that Newton's full steps can follow.
    coupling::StepReport cycles(int count, double peak) {
        coupling::StepReport last;
        const int steps = static_cast<int>(std::ceil(peak / 2.5e-4));
        for (int half = 0; half < 2 * count; ++half) {
            for (int k = 1; k <= steps; ++k) last = go_to(peak * (half % 2 == 0 ? k : steps - k) / steps, k == steps);
        }
        return last;
    }

    EnrichedMesh mesh_;
    coupling::Patch zone_ = plate_patch(mesh_);
    FineModel model_;
    FullNewton full_;
    void SetUp() override { model_.set_patch(zone_); }
};

TEST_F(Resting, ChangesNoDisplacementAndNoForce) {
    EXPECT_EQ(cycles(1, 8e-4).work.points_at_rest, 0);
    const coupling::WorkCounts work = cycles(2, 8e-4).work;
    EXPECT_GT(work.points_at_rest, work.points_evaluated / 4);
}

TEST_F(Resting, WhatWouldYieldIsWoken) {
    cycles(2, 8e-4);
    const coupling::StepReport overload = cycles(1, 2.4e-3);
    EXPECT_GT(overload.work.elements_woken, 0);
    cycles(1, 8e-4);
}

TEST_F(Resting, ItsReportsAreThoseOfAnAwakeZone) {
    cycles(3, 8e-4);
    const coupling::StepReport condensed = go_to(5e-4, false);
    EXPECT_GT(condensed.work.points_at_rest, 0);
    const coupling::StepReport whole = full_.last();
    EXPECT_NEAR(condensed.energy.stored, whole.energy.stored, 1e-11 * whole.energy.stored);
    EXPECT_NEAR(condensed.dissipation, whole.dissipation, 1e-10 * whole.dissipation);
    const coupling::ZoneState resting = model_.state(), awake = full_.state();
    double largest = 0.0;
    for (std::size_t i = 0; i < awake.stress.size(); ++i)
        largest = std::max(largest, std::abs(resting.stress[i] - awake.stress[i]));
    EXPECT_LT(largest, 1e-6);  // MPa
}

// A growth, which may come between, wakes all: who rests is looked for when the zone is asked again.
TEST_F(Resting, ItBeginsWhenTheZoneIsAskedAgain) {
    cycles(3, 8e-4);
    EXPECT_TRUE(model_.system().bulk().resting().elements().none());
    const auto still = [](const coupling::ZoneSnapshot& snapshot) { return std::ranges::count(snapshot.resting, 1); };
    model_.keep();
    EXPECT_EQ(still(model_.kept()), 0);
    EXPECT_GT(still(model_.snapshot()), 0);  // as a run that goes on
    EXPECT_EQ(model_.system().bulk().resting().elements().count(), still(model_.snapshot()));
}

/// The same with a crack, rough or not, most of whose faces are far from its tip.
class RestingFaces : public Resting, public testing::WithParamInterface<double> {
protected:
    static Case long_crack() {
        Case input = plate_case({mouth_of_pulled, mouth_of_pulled + 2.5 * (tip_of_pulled - mouth_of_pulled)});
        input.cracks[0].contact->friction = GetParam();
        return input;
    }
    RestingFaces() : Resting(long_crack(), 16) {}

    /// Between two strains that do not change who touches, until faces rest; how many of them in the last half cycle.
    int cycle_between(double one, double other) {
        int resting = 0;
        for (int half = 0; half < 6; ++half) {
            go_to(0.5 * (one + other), false);
            resting = model_.system().contact().resting().multipliers().count();
            go_to(half % 2 == 0 ? other : one, true);
        }
        return resting;
    }
    [[nodiscard]] int closed() const {
        return static_cast<int>(std::ranges::count_if(model_.system().contact().statuses(), fine::is_closed));
    }
};

TEST_P(RestingFaces, WhereTheyTouchAndWhereTheyAreApart) {
    go_to(-2e-4, false);
    const int all = closed();
    EXPECT_GT(all, 5);
    EXPECT_GT(cycle_between(-4e-4, -2e-4), all / 2);
    go_to(2e-4, true);  // they part, at rest
    EXPECT_EQ(closed(), 0);
    EXPECT_GT(cycle_between(4e-4, 2e-4), all / 2);
    go_to(-2e-4, true);  // and meet
    EXPECT_GT(closed(), 5);
}

INSTANTIATE_TEST_SUITE_P(Friction, RestingFaces, testing::Values(0.0, 0.6),
                         [](const auto& test) { return test.param > 0.0 ? "rough" : "smooth"; });

}  // namespace
}  // namespace stria::test
