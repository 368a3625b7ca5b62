// The load factor as an unknown: the equilibria are those of load control, whoever solves for them, wherever the loaded
// boundary lies.
#include <gtest/gtest.h>

#include <functional>

#include "app/run/monolithic/monolithic.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "tests/support/controlled_plates.hpp"
#include "tests/support/load_cases.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

/// A compact specimen: its loads act inside the insert, which is never in the zone.
Case small_ct() {
    Case input = small_sent({});
    input.mesh = {.specimen = "ct", .width = 50.0, .height = 60.0, .size = 5.0, .grading = {}};
    input.mesh.grading = {{.at = {{25.0, 0.0}}, .size = 1.0, .outer_size = 1.0, .radius = 3.0}};
    input.cracks[0].points = {{-12.5, 0.0}, {25.0, 0.0}};
    for (const double sign : {1.0, -1.0}) {
        BoundarySection& pin = input.boundaries[sign > 0.0 ? 0 : 1];
        pin = {};
        pin.on = sign > 0.0 ? "pin-top" : "pin-bottom";
        pin.force = Vec2(0.0, sign);
    }
    input.load.blocks = {{.cycles = 1, .max = 1200.0, .min = -200.0}};
    return input;
}

/// The traction on the top and, beside it, an edge that moves with the load factor.
Case traction_and_displacement() {
    Case input = small_sent({"fine.radius=60.0"});
    BoundarySection right;
    right.on = "right";
    right.displacement[0] = 1e-4;
    input.boundaries.push_back(right);
    return input;
}

/// The sides pulled too, across the crack's mouth: its jump bears a load inside the zone.
Case loaded_mouth() {
    Case input = small_sent({"fine.radius=30.0"});
    for (const double sign : {-1.0, 1.0}) {
        BoundarySection side;
        side.on = sign < 0.0 ? "left" : "right";
        side.traction = Vec2(0.5 * sign, 0.0);
        input.boundaries.push_back(side);
    }
    return input;
}

/// The bottom is moved; the top is pulled, and the sides are sheared, one of them by a dead load: they act on the
/// corners of the bottom, too.
Case moved_beside_tractions(const std::string& radius) {
    Case input = small_sent({"fine.radius=" + radius, "load.steps=4"});
    input.load.blocks = {{.cycles = 1, .max = 60.0, .min = -20.0}};
    BoundarySection bottom = input.boundaries[1], right;
    bottom.traction.reset();
    bottom.displacement = {0.0, -2e-4};
    right.on = "right";
    right.traction = Vec2(0.0, 0.05);
    input.load_cases = {dead_load("dead", 30.0)};
    input.boundaries = {bottom, input.boundaries[0], right, pulled_in_case("dead", "left", {0.0, -0.1})};
    return input;
}

struct ControlledCase {
    const char* name;
    std::function<Case()> input;
};

/// One run under load control, and one that follows its displacements.
class FollowedTargets : public testing::Test {
protected:
    static RunHistory follow(const Case& input, coarse::EquilibriumFactory& factory, Control control,
                             const std::vector<double>& targets) {
        const coarse::Scene scene = coarse::refined_scene(input);
        const coarse::Structure structure(scene, coarse::select_zone(scene, {1500.0}));
        const Eigen::VectorXd zero = Eigen::VectorXd::Zero(scene.enriched.unknowns);
        const coupling::Patch patch = coarse::make_patch(scene, structure.in_zone(), structure.gamma(), zero);
        const auto equilibrium = factory.make(structure, &patch, zero, 0.0);
        RunHistory history;
        for (const double target : targets) {
            Followed increment;
            increment.newton = find_equilibrium(*equilibrium, {control, target}, 0.0, {input.solver});
            EXPECT_TRUE(increment.newton.converged) << increment.newton.failure << increment.newton.table();
            increment.load_factor = equilibrium->load_factor();
            increment.displacement = equilibrium->structure_displacement();
            mean_.push_back(scene.displacement_weights.dot(increment.displacement));
            increment.zone = equilibrium->commit({});
            history.increments.push_back(increment);
        }
        return history;
    }

    static RunHistory follow_direct(const Case& input, Control control, const std::vector<double>& targets) {
        fine::FineModel fine(input);
        coarse::CondensedFactory factory(&fine, input);
        return follow(input, factory, control, targets);
    }

    static void expect_same(const RunHistory& one, const RunHistory& other) {
        const double load = one.at_maximum().load_factor;
        for (std::size_t k = 0; k < one.increments.size(); ++k) {
            const Followed &a = one.increments[k], &b = other.increments[k];
            EXPECT_NEAR(a.load_factor, b.load_factor, 1e-9 * load) << "increment " << k + 1;
            EXPECT_LT((a.displacement - b.displacement).lpNorm<Eigen::Infinity>(),
                      1e-9 * one.at_maximum().displacement.lpNorm<Eigen::Infinity>());
            EXPECT_NEAR(a.zone.dissipation, b.zone.dissipation, 1e-8 * one.at_maximum().zone.dissipation);
        }
    }

    void SetUp() override { mean_.clear(); }

    inline static std::vector<double> mean_;  // displacements of the increments followed
};

class DisplacementControl : public FollowedTargets, public testing::WithParamInterface<ControlledCase> {};

TEST_P(DisplacementControl, FindsTheLoadsOfLoadControl) {
    const Case input = GetParam().input();
    const LoadBlock& block = input.load.blocks[0];
    std::vector<double> loads;
    for (const double share : {0.25, 0.5, 0.75, 1.0}) loads.push_back(share * block.max);
    for (const double share : {0.5, 0.0}) loads.push_back(share * block.max);
    loads.insert(loads.end(), {0.5 * block.min, block.min});
    const RunHistory by_load = follow_direct(input, Control::Load, loads);
    EXPECT_GT(by_load.at_maximum().zone.dissipation, 0.0);
    EXPECT_GT(by_load.increments.back().zone.contact_length[0], 0.0);

    const std::vector<double> displacements = mean_;
    mean_.clear();
    const RunHistory direct = follow_direct(input, Control::Displacement, displacements);
    expect_same(by_load, direct);
    for (std::size_t k = 0; k < displacements.size(); ++k)
        EXPECT_NEAR(mean_[k], displacements[k], 1e-12 * displacements[3]);

    MonolithicFactory factory(input);
    const RunHistory whole = follow(input, factory, Control::Displacement, displacements);
    expect_same(direct, whole);
    for (std::size_t k = 0; k < displacements.size(); ++k)
        EXPECT_EQ(direct.increments[k].newton.count(), whole.increments[k].newton.count()) << "increment " << k + 1;
}

INSTANTIATE_TEST_SUITE_P(
    Sceneries, DisplacementControl,
    testing::Values(ControlledCase{"loads_on_the_structure", [] { return small_sent({"fine.radius=15.0"}); }},
                    ControlledCase{"loads_on_the_zone", [] { return small_sent({"fine.radius=200.0"}); }},
                    ControlledCase{"pins", small_ct}, ControlledCase{"an_edge_moves_too", traction_and_displacement},
                    ControlledCase{"loads_inside_the_zone", loaded_mouth}),
    [](const auto& test) { return test.param.name; });

TEST(ElasticDisplacementControl, NeedsNoNewton) {
    Case input = small_sent({});
    input.material.yield_stress.reset();
    input.cracks[0].contact.reset();
    input.load = {.steps = 2, .blocks = {{.cycles = 1, .max = 0.1, .min = 0.0}}, .control = Control::Displacement};
    coarse::CondensedFactory factory(nullptr, input);
    const RunHistory run = run_analysis(input, factory);
    const coarse::Scene scene = coarse::refined_scene(input);
    const double compliance = coarse::Structure(scene).loads().displacement_reading().per_load_factor;
    EXPECT_EQ(run.increments[0].newton.count(), 1);
    EXPECT_NEAR(run.increments[0].load_factor, 0.1 / compliance, 1e-12 * 0.1 / compliance);
    EXPECT_NEAR(scene.displacement_weights.dot(run.increments[0].displacement), 0.1, 1e-12);
    EXPECT_NEAR(run.increments[0].tips[0].K_I, run.nominal[0].K_I * run.increments[0].load_factor, 1e-6);
}

TEST(ElasticDisplacementControl, BesideADeadLoadHasTheLoadFactorOfTheNominalBody) {
    Case input = small_sent({});
    input.load.blocks = {{.cycles = 1, .max = 0.1, .min = 0.05}};
    input.material.yield_stress.reset();
    input.cracks[0].contact.reset();
    input.load.control = Control::Displacement;
    input.load_cases = {dead_load("dead", 30.0)};
    for (const double side : {1.0, -1.0})
        input.boundaries.push_back(pulled_in_case("dead", side > 0.0 ? "top" : "bottom", {0.0, side}));
    coarse::CondensedFactory factory(nullptr, input);
    const RunHistory run = run_analysis(input, factory);
    const coarse::Scene scene = coarse::refined_scene(input);
    const coarse::UnitDisplacement unit = unit_displacement(coarse::solve_nominal(scene).fields);
    ASSERT_EQ(unit.of_cases.size(), 1U);
    int controlled = 0;
    for (const Followed& increment : run.increments) {
        const coarse::Target& target = increment.step.target;
        if (target.control != Control::Displacement) continue;  // the dead load comes on
        ++controlled;
        EXPECT_NEAR(increment.load_factor, unit.load_factor_at(target.value, target.cases), 1e-8) << target.value;
    }
    EXPECT_GT(controlled, 8);
}

// A dead load in proportion to the main one is part of one load, the same plate's under load control.
TEST_F(FollowedTargets, ADeadLoadAndAControlledDisplacementAreOneLoad) {
    const Case input = beside_a_dead_load({.cycles = 1, .max = 0.16, .min = -0.05});
    const RunHistory run = run_direct(input);
    expect_straight_on(run, 0.16);
    ASSERT_EQ(run.increments.size(), 4 * half_cycle);
    EXPECT_GT(run.increments[3 * half_cycle - 1].zone.contact_length[0], 0.0);

    std::vector<double> loads;
    for (const Followed& increment : run.increments)
        loads.push_back(increment.load_factor + increment.step.target.cases[0]);
    const RunHistory one = follow_direct(small_sent({"fine.radius=200.0"}), Control::Load, loads);
    const double dissipated = one.increments.back().zone.dissipation;
    EXPECT_GT(dissipated, 0.0);
    for (std::size_t k = 0; k < loads.size(); ++k) {
        EXPECT_NEAR(run.increments[k].machine.displacement, mean_[k], 1e-9 * 0.16) << "increment " << k + 1;
        EXPECT_NEAR(run.increments[k].zone.dissipation, one.increments[k].zone.dissipation, 1e-8 * dissipated);
    }

    MonolithicFactory factory(input);
    const RunHistory whole = run_analysis(input, factory);
    ASSERT_EQ(whole.increments.size(), run.increments.size());
    for (std::size_t k = 0; k < loads.size(); ++k)
        EXPECT_NEAR(whole.increments[k].load_factor, run.increments[k].load_factor, 1e-9 * 100.0);
}

// Equilibrium of the whole body: what a machine pulls with at an edge that it moves is what all loads pull.
TEST(AMovedEdge, IsPulledByWhatTheLoadsPull) {
    for (const std::string radius : {"15.0", "300.0"}) {
        const Case input = moved_beside_tractions(radius);
        MonolithicFactory factory(input);
        for (const RunHistory& run : {run_direct(input), run_analysis(input, factory)}) {
            EXPECT_GT(run.increments.back().zone.dissipation, 0.0);
            for (const Followed& increment : run.increments) {
                const double pulled = increment.load_factor * (50.0 + 200.0 * 0.05);
                EXPECT_NEAR(increment.machine.force, pulled - increment.step.target.cases[0] * 200.0 * 0.1,
                            1e-8 * 3600.0);
            }
        }
    }
}

TEST(ElasticDisplacementControl, RefusesWhatNoLoadMoves) {
    Case input = small_sent({"load.control=\"displacement\""});
    for (BoundarySection& boundary : input.boundaries) boundary.traction = Vec2::Zero();
    EXPECT_THROW(coarse::refined_scene(input), CaseError);
}

}  // namespace
}  // namespace stria::test
