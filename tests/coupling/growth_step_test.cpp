// What a step of growth factors: the far part and the middle once, the core where the zone changes; which elements it
// condenses and builds; and that the nominal solution is that of the whole body.
#include <gtest/gtest.h>

#include <set>

#include "coarse/analysis/fatigue_analysis.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "common/index.hpp"
#include "fine/zone/fine_model.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::test {
namespace {

struct Grown {
    coupling::WorkCounts made;
    std::vector<std::int64_t> built;  // elements of the zone, by the end of each cycle
    int changes_of_zone = 0;
    int near = 0;                           // elements, at the end
    std::vector<double> K, K_of_the_whole;  // of each length
    std::set<const Vec2*> meshes;           // the nodes of each, wherever they stand
    std::vector<SharedList<Vec2>> held;     // lest another one takes their place
    int splits = 0;                         // steps that split elements
};

struct Growth {
    int refine = 1, cycles = 4;
    double size = 40.0, crack = 7.3;  // mm, of the plate and the crack
};

/// Elements of 1 mm; by a factor of 4 smaller about the tip, with room for its way.
Grown grow(const Growth& growth) {
    const auto [refine, cycles, size, crack] = growth;
    Case input = pulled_plate(1.0, true, true);
    input.mesh.width = input.mesh.height = size;
    input.cracks[0].points = {{0.0, size / 2.0 + 0.4}, {crack, size / 2.0 + 0.4}};
    input.material.kinematic = {{.C = 4000.0, .gamma = 0.0}};
    input.load.steps = 4;
    input.load.blocks = {{.cycles = cycles, .max = 30.0, .min = 0.0}};
    input.growth = GrowthSection{.increment = refine > 1 ? 0.05 : 0.3};
    input.fine.radius = 1.5;
    input.fine.refine = refine;
    const coarse::Scene scene = coarse::refined_scene(input);
    fine::FineModel fine(input);
    coarse::CondensedFactory factory(&fine, input);
    Grown grown;
    ElementSet in_zone;
    coarse::Listener listener;
    listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure& structure) {
        if (increment.step.ends_cycle) grown.built.push_back(increment.zone.work.elements_built);
        if (structure.in_zone() != in_zone) ++grown.changes_of_zone;
        in_zone = structure.in_zone();
        const coarse::Scene& present = structure.scene();
        for (const SharedList<Vec2>& nodes :
             {present.mesh.nodes(), present.enriched.nodes, nominal_functions(present).nodes}) {
            grown.held.push_back(nodes);
            grown.meshes.insert(nodes.data());
        }
        grown.near = static_cast<int>(structure.elements().near().size());
        if (!grown.K.empty() && grown.K.back() == increment.nominal[0].K_I) return;
        grown.K.push_back(increment.nominal[0].K_I);
        grown.K_of_the_whole.push_back(coarse::solve_nominal(structure.scene()).tips[0].K_I);
    };
    coarse::FatigueAnalysis analysis(scene, factory, listener);
    analysis.run();
    grown.made = analysis.effort().work;
    grown.splits = analysis.effort().counts.mesh_splits;
    return grown;
}

class GrowthStepOf : public testing::TestWithParam<int> {};

TEST_P(GrowthStepOf, CondensesTheStructureWhereItsZoneChangesAndTheFarBodyOnce) {
    const Growth growth{.refine = GetParam()};
    const Grown grown = grow(growth);
    EXPECT_EQ(grown.made.structure_factorisations, grown.changes_of_zone);
    EXPECT_EQ(grown.made.structure_factorisations + grown.made.structure_factors_kept, 1 + growth.cycles);
    EXPECT_EQ(grown.changes_of_zone == 1, GetParam() > 1);
    EXPECT_EQ(grown.made.far_factorisations, 1);
}

TEST_P(GrowthStepOf, FindsTheNominalKOfTheWholeBody) {
    const Growth growth{.refine = GetParam()};
    const Grown grown = grow(growth);
    ASSERT_EQ(grown.K.size(), at(1 + growth.cycles));
    for (std::size_t k = 0; k < grown.K.size(); ++k)
        EXPECT_NEAR(grown.K[k], grown.K_of_the_whole[k], 1e-11 * grown.K_of_the_whole[k]) << k;
}

// Where small elements follow the tip, too: it lies behind them until they reach it.
TEST(GrowthStep, CondensesTheWakeForManyNominalSolutions) {
    const Growth growth{.refine = 16, .cycles = 12};
    const Grown grown = grow(growth);
    EXPECT_GT(grown.made.behind_factorisations, 0);
    EXPECT_LT(grown.made.behind_factorisations, growth.cycles / 3);
    ASSERT_EQ(grown.K.size(), at(1 + growth.cycles));
    for (std::size_t k = 0; k < grown.K.size(); ++k)
        EXPECT_NEAR(grown.K[k], grown.K_of_the_whole[k], 1e-11 * grown.K_of_the_whole[k]) << k;
}

/// In steps of growth that leave the middle as it is: coarse elements of which a stiffness was assembled, per step.
double condensed_per_step(double size, double crack, int& near) {
    constexpr int few = 2, more = 4;
    const Grown before = grow({.cycles = few, .size = size, .crack = crack}),
                after = grow({.cycles = few + more, .size = size, .crack = crack});
    EXPECT_EQ(before.made.middle_factorisations, 1);
    EXPECT_EQ(after.made.middle_factorisations, 1);
    EXPECT_EQ(after.made.far_factorisations, 1);
    near = after.near;
    const auto condensed = [](const Grown& grown) { return grown.made.structure_elements_assembled; };
    return static_cast<double>(condensed(after) - condensed(before)) / more;
}

// The rings grow with the crack and the body, and what is near with them: a core about the tip and the wake does not.
TEST(GrowthStep, CondensesTheCoreAlone) {
    int near = 0, near_in_large = 0;
    const double condensed = condensed_per_step(80.0, 14.3, near);
    const double in_large = condensed_per_step(120.0, 24.3, near_in_large);
    EXPECT_GT(near_in_large, 2.5 * near);
    EXPECT_LT(in_large, 1.4 * condensed) << "the wake is longer";
    EXPECT_LT(in_large, near_in_large / 3.0) << "twice the core, for the nominal solution and for the new zone";
}

// However long the wake and large the body. Where small elements follow the tip they are built, too.
TEST(GrowthStep, BuildsTheElementsNearTheTipAlone) {
    const Grown grown = grow({.refine = 4, .cycles = 16}), in_large = grow({.refine = 4, .cycles = 6, .size = 80.0});
    const auto least = [](const Grown& of, std::size_t from, std::size_t to) {
        std::int64_t built = of.built.front();
        for (std::size_t k = from; k < to; ++k) built = std::min(built, of.built[k] - of.built[k - 1]);
        return built;
    };
    EXPECT_GT(least(grown, 1, 6), 0);
    EXPECT_EQ(least(grown, 10, 16), least(grown, 1, 6));
    EXPECT_EQ(least(in_large, 1, 6), least(grown, 1, 6));
    EXPECT_LT(grown.built.back(), 3 * grown.built.front()) << "fifteen steps, and the zone of the first";
}

// Nodes and elements are those of the body, and so is what is looked up on them: in a step no pass makes them anew.
TEST(GrowthStep, LeavesTheMeshAsItIs) {
    const Grown grown = grow({.refine = 1}), refined = grow({.refine = 4, .cycles = 12});
    EXPECT_EQ(grown.meshes.size(), 1U);
    EXPECT_EQ(at(refined.splits), refined.meshes.size() - 1);
    EXPECT_LT(refined.splits, 4);
}

INSTANTIATE_TEST_SUITE_P(Refinement, GrowthStepOf, testing::Values(1, 4));

}  // namespace
}  // namespace stria::test
