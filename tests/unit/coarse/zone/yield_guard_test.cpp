// The guard sees every coarse element that would yield, and looks at the far ones only where their bound leaves a
// doubt.
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/yield_guard.hpp"

#include <gtest/gtest.h>

#include "coarse/analysis/fatigue_analysis.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/zone/structure_stresses.hpp"
#include "fine/zone/fine_model.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

constexpr double yield_stress = 300.0;

/// A wide plate, a plastic zone at the tip of its crack.
Case plate() {
    Case input = test::pulled_plate(0.5, true, false);
    input.mesh.width = input.mesh.height = 40.0;
    input.cracks[0].points = {{0.0, 20.2}, {7.3, 20.2}};
    input.material.yield_stress = yield_stress;
    input.load.steps = 8;
    input.load.blocks = {{.cycles = 2, .max = 70.0, .min = -20.0}};
    input.fine.radius = 1.5;
    return input;
}

/// Two forces pull at it far from the tip.
Case with_forces(double force) {
    Case input = plate();
    for (const double side : {1.0, -1.0}) {
        BoundarySection point;
        point.on = "point";
        point.at = Vec2(36.0, 20.0 + 2.0 * side);
        point.force = Vec2(0.0, force * side);
        input.boundaries.push_back(point);
    }
    return input;
}

struct Watched {
    int increments = 0, extensions = 0;
    std::int64_t full_checks = 0, checks_by_bound = 0;
    ElementSet in_zone;
};

Watched run(const Case& input) {
    const Scene scene = refined_scene(input);
    fine::FineModel fine(input);
    CondensedFactory factory(&fine, input);
    Watched watched;
    Listener listener;
    listener.accepted = [&](const Increment& increment, const Structure& structure) {
        ++watched.increments;
        const Eigen::VectorXd u = increment.equilibrium->structure_displacement();
        EXPECT_TRUE(elements_beyond(yield_stress * (1.0 + 1e-9), structure, u).empty()) << increment.number;
        EXPECT_LE(largest_far_stress(structure, u, StressPart::Whole), yield_stress * (1.0 + 1e-9));
    };
    FatigueAnalysis analysis(scene, factory, listener);
    analysis.run();
    watched.extensions = analysis.effort().counts.zone_extensions;
    watched.full_checks = analysis.effort().work.structure_checks_full;
    watched.checks_by_bound = analysis.effort().work.structure_checks_by_bound;
    watched.in_zone = analysis.structure().in_zone();
    return watched;
}

TEST(YieldGuard, LooksAtNoFarElementWhereTheTipAloneFlows) {
    const Watched tip = run(plate());
    EXPECT_GT(tip.increments, 16);
    EXPECT_EQ(tip.full_checks, 0);
    EXPECT_EQ(tip.checks_by_bound, tip.increments + tip.extensions);
}

TEST(YieldGuard, FindsWhatYieldsFarFromTheTip) {
    const Case input = with_forces(5.0);
    const Watched forces = run(input);
    EXPECT_GT(forces.extensions, 0);
    EXPECT_GT(forces.full_checks, 0);
    EXPECT_GT(forces.checks_by_bound, forces.full_checks);
    EXPECT_EQ(forces.full_checks + forces.checks_by_bound, forces.increments + forces.extensions);
    const Scene scene = refined_scene(input);
    int far_in_zone = 0;
    for (const int e : forces.in_zone.members())
        if (scene.mesh->nodes[at(scene.mesh->elements[at(e)][0])].x() > 30.0) ++far_in_zone;
    EXPECT_GT(far_in_zone, 0);
}

}  // namespace
}  // namespace stria::coarse
