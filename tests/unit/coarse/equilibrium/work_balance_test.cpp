// The work of the loads of an elastic body is what it stores, whatever loads it and on whatever way.
#include "coarse/equilibrium/work_balance.hpp"

#include <gtest/gtest.h>

#include "coarse/equilibrium/condensed/condensed_equilibrium.hpp"
#include "coarse/equilibrium/newton.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "tests/support/plate_of_load_cases.hpp"

namespace stria::coarse {
namespace {

/// An elastic plate under loads with factors of their own.
class WorkBalanceOf : public testing::Test {
protected:
    /// On to these factors.
    void go_to(const LoadFactors& factors, const coupling::StepReport& zone = {}) {
        const Target target{.value = factors.main, .cases = factors.cases};
        ASSERT_TRUE(find_equilibrium(equilibrium, target, Predictor(), {scene.input.solver}).converged);
        add_increment(balance, structure, equilibrium.structure_displacement(), factors, equilibrium.machine_reading(),
                      zone);
        static_cast<void>(equilibrium.commit({}));
    }

    const Scene scene = refined_scene(test::plate_of_load_cases(1.0, false, false));
    const Structure structure{scene};
    const Eigen::VectorXd unloaded = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    CondensedEquilibrium equilibrium{structure, nullptr, scene.input, unloaded, 0.0};
    WorkBalance balance;
};

TEST_F(WorkBalanceOf, LoadsIsWhatTheBodyStores) {
    go_to({30.0, Eigen::Vector2d(-20.0, 50.0)});
    const Eigen::VectorXd u = equilibrium.structure_displacement();
    const double stored = 0.5 * u.dot(structure.elements().internal_force(u));
    EXPECT_GT(stored, 0.0);
    EXPECT_NEAR(balance.stored, stored, 1e-10 * stored);
    EXPECT_NEAR(balance.external, stored, 1e-9 * stored);
    EXPECT_LT(balance.share_of_largest(), 1e-9);
}

TEST_F(WorkBalanceOf, LoadsIsTheSameOnEveryWayButNotItsShares) {
    go_to({30.0, Eigen::Vector2d(-20.0, 50.0)});
    const double straight = balance.external;
    const Eigen::VectorXd shares = balance.by_cases;
    go_to({30.0, Eigen::Vector2d(-20.0, 0.0)});
    go_to({0.0, Eigen::Vector2d(0.0, 0.0)});
    EXPECT_NEAR(balance.external, 0.0, 1e-9 * straight);
    EXPECT_GE(balance.largest, straight);
    go_to({0.0, Eigen::Vector2d(0.0, 50.0)});
    go_to({30.0, Eigen::Vector2d(-20.0, 50.0)});
    EXPECT_NEAR(balance.external, straight, 1e-9 * straight);
    EXPECT_GT((balance.by_cases - shares).norm(), 1e-3 * straight);
}

// Of a load that pulls alone: half of force times way.
TEST_F(WorkBalanceOf, AloneIsOfThatLoad) {
    go_to({0.0, Eigen::Vector2d(0.0, 50.0)});
    const Eigen::VectorXd u = equilibrium.structure_displacement();
    EXPECT_NEAR(balance.by_cases[1], 0.5 * 50.0 * scene.case_forces[1].dot(u), 1e-9 * balance.external);
    EXPECT_NEAR(balance.by_cases[0], 0.0, 1e-12 * balance.external);
}

// The bottom goes down by 6e-3 mm where it holds what the top is pulled by, 30 MPa over 20 mm.
TEST_F(WorkBalanceOf, WhatIsMovedIsTheReactionTimesThat) {
    go_to({30.0, Eigen::Vector2d::Zero()});
    go_to({30.0, Eigen::Vector2d(-20.0, 0.0)});
    EXPECT_NEAR(std::abs(balance.by_cases[0]), 30.0 * 20.0 * 6e-3, 1e-9);
    EXPECT_NEAR(balance.by_cases[1], 0.0, 1e-9);
    EXPECT_NEAR(balance.error(), 0.0, 1e-9);
}

TEST_F(WorkBalanceOf, TheZoneIsAddedOnceAnIncrement) {
    const LoadFactors factors{30.0, Eigen::Vector2d(0.0, 50.0)};
    go_to(factors);
    const WorkBalance before = balance;
    coupling::StepReport zone;
    zone.dissipation = 7.0;
    zone.energy.stored = 3.0;
    zone.energy.released = 2.0;
    zone.energy.friction = 5.0;
    zone.energy.load_path = 0.25;
    zone.energy.case_paths = Eigen::Vector2d(0.0, 0.5);
    for (int increment = 1; increment <= 2; ++increment) {
        go_to(factors, zone);
        EXPECT_NEAR(balance.stored, before.stored + 3.0, 1e-9);  // a state
        EXPECT_NEAR(balance.dissipated, 12.0 * increment, 1e-12);
        EXPECT_NEAR(balance.by_friction, 5.0 * increment, 1e-12);
        EXPECT_NEAR(balance.released, 2.0 * increment, 1e-12);
        EXPECT_NEAR(balance.external - before.external, (30.0 * 0.25 + 50.0 * 0.5) * increment, 1e-9);
        EXPECT_NEAR(balance.by_cases[1] - before.by_cases[1], 50.0 * 0.5 * increment, 1e-9);
    }
}

// Faces part or meet in an increment of several loads: what trapezoids lack is shared as what lies above the load that
// they start from, and of loads that stay as they were nothing is.
TEST_F(WorkBalanceOf, ContactTakesItsPartOfThoseLoadsThatChange) {
    go_to({10.0, Eigen::Vector2d(0.0, 50.0)});
    const WorkBalance before = balance;
    WorkBalance without = balance;
    coupling::StepReport zone;
    zone.energy.contact = -0.5;
    const LoadFactors dead_load_stays{30.0, Eigen::Vector2d(0.0, 50.0)};
    go_to(dead_load_stays, zone);
    add_increment(without, structure, equilibrium.structure_displacement(), dead_load_stays,
                  equilibrium.machine_reading(), {});
    EXPECT_NEAR(balance.external, without.external - 0.5, 1e-12);
    EXPECT_NEAR(balance.by_cases[1], without.by_cases[1], 1e-9 * std::abs(before.external));
    without = balance;
    const LoadFactors dead_load_grows{30.0, Eigen::Vector2d(0.0, 80.0)};
    go_to(dead_load_grows, zone);
    add_increment(without, structure, equilibrium.structure_displacement(), dead_load_grows,
                  equilibrium.machine_reading(), {});
    EXPECT_NEAR(balance.by_cases[1], without.by_cases[1] - 0.5, 1e-9 * std::abs(before.external));
    // Both grow: the main load moves the bottom, too.
    const WorkBalance between = balance;
    without = balance;
    const LoadFactors both_grow{60.0, Eigen::Vector2d(0.0, 120.0)};
    go_to(both_grow, zone);
    add_increment(without, structure, equilibrium.structure_displacement(), both_grow, equilibrium.machine_reading(),
                  {});
    const double of_main = 30.0 * (std::abs(balance.load_displacement - between.load_displacement) +
                                   std::abs(balance.imposed_force - between.imposed_force)),
                 of_case = 40.0 * std::abs(balance.case_displacements[1] - between.case_displacements[1]);
    EXPECT_NEAR(balance.by_cases[1], without.by_cases[1] - 0.5 * of_case / (of_main + of_case),
                1e-9 * std::abs(before.external));
}

// An initial stress has done work before anybody loads the body.
TEST_F(WorkBalanceOf, ABeginningWithEnergyIsNobodysWork) {
    coupling::StepReport zone;
    zone.energy.stored = 40.0;
    zone.dissipation = 2.0;
    go_to({0.0, Eigen::Vector2d::Zero()}, zone);
    EXPECT_NEAR(balance.error(), -42.0, 1e-9);
    begin_here(balance);
    EXPECT_NEAR(balance.error(), 0.0, 1e-12);
    zone.dissipation = 0.0;
    go_to({30.0, Eigen::Vector2d(-20.0, 50.0)}, zone);
    EXPECT_LT(std::abs(balance.error()), 1e-9 * balance.external);
}

// What its zone has taken over the structure's loads do no work on any more: the next trapezoid begins on the new way.
TEST_F(WorkBalanceOf, AStructureThatHasGivenElementsAwayBeginsAnew) {
    const LoadFactors factors{30.0, Eigen::Vector2d(0.0, 50.0)};
    go_to(factors);
    const WorkBalance before = balance;
    balance.load_displacement += 4.0;
    balance.case_displacements += Eigen::Vector2d(2.0, 3.0);
    restart(balance, structure, equilibrium.structure_displacement());
    EXPECT_NEAR(balance.load_displacement, before.load_displacement, 1e-12 * std::abs(before.load_displacement));
    EXPECT_LT((balance.case_displacements - before.case_displacements).norm(), 1e-9);
    go_to(factors);
    EXPECT_NEAR(balance.external, before.external, 1e-9 * before.external);
}

}  // namespace
}  // namespace stria::coarse
