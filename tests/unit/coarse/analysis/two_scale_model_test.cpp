// Structure and zone in one equilibrium: what is committed stays so while the zone grows, the cracks do, and a run goes
// on from what was written.
#include "coarse/analysis/two_scale_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "fine/zone/fine_model.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

const Note say_nothing = [](const std::string&) {};

/// One body and its model; without a zone nobody asks the fine side.
struct Pulled {
    explicit Pulled(const Scene& scene, const AnalysisState* from = nullptr)
        : body(scene, effort, say_nothing, from), fine(scene.input),
          factory(body.has_zone() ? &fine : nullptr, scene.input),
          model(body, scene.input.solver, closure, factory, effort, say_nothing, from) {}

    Increment go_to(double load_factor, bool releases = false) {
        LoadStep step;
        step.target.value = load_factor;
        step.releases = releases;
        const NewtonReport report = model.solve(step, [] { return true; });
        EXPECT_TRUE(report.converged) << load_factor;
        return model.commit(step, report);
    }
    [[nodiscard]] AnalysisState written() const {
        AnalysisState state;
        body.write(state);
        model.write(state);
        model.write_dear(state);
        return state;
    }

    CoarseEffort effort;
    ClosureMeter closure;
    CrackedBody body;
    fine::FineModel fine;
    CondensedFactory factory;
    TwoScaleModel model;
};

Case pulled(bool plastic) {
    Case input = test::pulled_plate(1.0, plastic, false);
    input.load.blocks = {{.cycles = 1, .max = 60.0, .min = 0.0}};
    if (plastic) input.fine.radius = 2.0;
    input.solver.tolerance = 1e-11;
    input.growth = GrowthSection{};
    return input;
}

GrownScene grown(const CrackedBody& body, double by) {
    Case input = body.scene().input;
    input.cracks[0].points.back().x() += by;
    return {std::make_unique<Scene>(make_scene(input, body.scene().mesh)), nullptr};
}

TEST(TwoScaleModel, WithoutAZoneIsTheNominalBody) {
    const Scene scene = refined_scene(pulled(false));
    Pulled pulled(scene);
    const Increment first = pulled.go_to(20.0), second = pulled.go_to(30.0);
    EXPECT_EQ(pulled.model.load_factor(), 30.0);
    EXPECT_NEAR(second.tips.at(0).K_I, 30.0 * pulled.body.nominal().at(0).K_I, 1e-9 * second.tips[0].K_I);
    EXPECT_NEAR(second.machine.displacement, 1.5 * first.machine.displacement, 1e-12 * second.machine.displacement);
    EXPECT_NEAR(second.work.external, second.work.stored, 1e-9 * second.work.stored);
    EXPECT_NEAR(second.work.external, 2.25 * first.work.external, 1e-9 * second.work.external);
}

TEST(TwoScaleModel, WithAZoneThatStaysElasticIsTheSameBody) {
    const Scene one = refined_scene(pulled(false)), two = refined_scene(pulled(true));
    Pulled whole(one), parted(two);
    ASSERT_TRUE(parted.body.has_zone());
    const Increment expected = whole.go_to(1.0), found = parted.go_to(1.0);
    EXPECT_NEAR(found.work.stored, expected.work.stored, 0.05 * expected.work.stored);  // other functions at the tip
    EXPECT_EQ(found.work.dissipated, 0.0);
    EXPECT_NEAR(found.work.external, found.work.stored, 1e-9 * found.work.stored);
    EXPECT_GT(found.zone.energy.stored, 0.0);
}

TEST(TwoScaleModel, ABodyThatMovesTooFarGivesWay) {
    Case input = pulled(true);
    input.material.yield_stress = 1e15;
    const Scene scene = refined_scene(input);
    Pulled pulled(scene);
    LoadStep step;
    step.target.value = 1e7;
    const NewtonReport report = pulled.model.solve(step, [] { return true; });
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.failure, "the body gives way");
}

// The elements that join are at rest as they were: what is committed balances on.
TEST(TwoScaleModel, KeepsItsEquilibriumWhereTheZoneGrows) {
    const Scene scene = refined_scene(pulled(true));
    Pulled pulled(scene);
    const Increment before = pulled.go_to(25.0);
    const int outside = [&] {
        const auto is_loaded = [&](int node) { return scene.unit_force[scene.enriched.unknown(node, 0, 1)] > 0.0; };
        int e = 0;
        while (pulled.body.in_zone().contains(e) || std::ranges::none_of(scene.mesh->elements[at(e)], is_loaded)) ++e;
        return e;
    }();
    LoadStep tried;
    tried.target.value = 30.0;
    ASSERT_TRUE(pulled.model.solve(tried, [] { return true; }).converged);
    const auto zone = pulled.body.in_zone().count();
    pulled.model.extend_zone({outside}, pulled.model.prepare_extension());
    EXPECT_TRUE(pulled.body.in_zone().contains(outside));
    EXPECT_GT(pulled.body.in_zone().count(), zone);
    EXPECT_EQ(pulled.effort.counts.zone_extensions, 1);
    EXPECT_EQ(pulled.model.load_factor(), 25.0);
    EXPECT_NEAR(pulled.model.loaded_displacement(), before.machine.displacement, 1e-12);
    const Increment after = pulled.go_to(25.0);
    EXPECT_NEAR(after.machine.displacement, before.machine.displacement, 1e-5 * before.machine.displacement);
    EXPECT_NEAR(after.work.external, before.work.external, 1e-5 * before.work.external);
    EXPECT_NEAR(after.work.stored, before.work.stored, 1e-5 * before.work.stored);
}

// At the mouth of a crack an edge is pulled on either side of it. What that load works on is the zone's from there on.
TEST(TwoScaleModel, CountsTheWorkOfALoadOnceWhereItsElementJoinsTheZone) {
    Case input = pulled(true);
    for (const char* edge : {"left", "right"}) {
        BoundarySection pulled_aside = input.boundaries.front();
        pulled_aside.on = edge;
        pulled_aside.traction = Vec2(edge == std::string("left") ? -1.0 : 1.0, 0.0);
        input.boundaries.push_back(pulled_aside);
    }
    const Scene scene = refined_scene(input);
    Pulled pulled(scene);
    const Increment before = pulled.go_to(25.0);
    const int mouth = scene.enriched.pieces.front().element;
    ASSERT_FALSE(pulled.body.in_zone().contains(mouth));
    pulled.model.extend_zone({mouth}, pulled.model.prepare_extension());
    ASSERT_TRUE(pulled.body.in_zone().contains(mouth));
    const Increment after = pulled.go_to(25.0);
    EXPECT_NEAR(after.work.external, before.work.external, 1e-8 * before.work.external);
    EXPECT_LT(pulled.go_to(30.0).work.share_of_largest(), 1e-3);
}

// Figure 3 (a): no displacement changes, so the machine reads what it did.
TEST(TwoScaleModel, LengthensItsCracksWithoutMovingAnything) {
    const Scene scene = refined_scene(pulled(true));
    Pulled pulled(scene);
    const Increment before = pulled.go_to(25.0);
    pulled.model.prepare_growth();
    static_cast<void>(pulled.model.lengthen_cracks(grown(pulled.body, 1.2), 1));
    EXPECT_NEAR(pulled.body.scene().enriched.tips.at(0).position.x(), 8.5, 1e-12);
    EXPECT_NEAR(pulled.model.loaded_displacement(), before.machine.displacement, 1e-12);
    EXPECT_EQ(pulled.model.load_factor(), 25.0);
    const Increment after = pulled.go_to(25.0);
    EXPECT_GT(after.machine.displacement, 1.01 * before.machine.displacement);
    EXPECT_GT(after.work.released, 0.0);
}

// From J, and the energy of a body that no zone looks at.
TEST(TwoScaleModel, ReleasesIrwinsRateWithoutAZone) {
    const Scene scene = refined_scene(pulled(false));
    Pulled pulled(scene);
    const Increment before = pulled.go_to(25.0);
    pulled.model.prepare_growth();
    static_cast<void>(pulled.model.lengthen_cracks(grown(pulled.body, 0.12), 1));
    const Increment after = pulled.go_to(25.0, true);
    EXPECT_NEAR(after.tips.at(0).K_I, 25.0 * pulled.body.nominal().at(0).K_I, 1e-9 * after.tips[0].K_I);
    const double J = 0.5 * (before.tips.at(0).J + after.tips[0].J);
    EXPECT_NEAR(after.work.released, 0.12 * J, 0.01 * 0.12 * J);
    EXPECT_LT(after.work.share_of_largest(), 1e-9);
    EXPECT_GT(after.work.external, before.work.external);
}

TEST(TwoScaleModel, GoesOnFromWhatWasWrittenToTheLastBit) {
    const Scene scene = refined_scene(pulled(true));
    Pulled pulled(scene);
    pulled.go_to(40.0);
    const AnalysisState state = pulled.written();
    EXPECT_EQ(state.load_factor, 40.0);
    EXPECT_GT(state.largest_force, 0.0);
    const Increment on = pulled.go_to(55.0);
    Pulled resumed(scene, &state);
    EXPECT_EQ(resumed.model.load_factor(), 40.0);
    const Increment again = resumed.go_to(55.0);
    EXPECT_EQ(again.machine.displacement, on.machine.displacement);
    EXPECT_EQ(again.tips.at(0).J, on.tips.at(0).J);
    EXPECT_EQ(again.work.external, on.work.external);
    EXPECT_EQ(again.work.dissipated, on.work.dissipated);
    EXPECT_GT(on.work.dissipated, 0.0);
}

}  // namespace
}  // namespace stria::coarse
