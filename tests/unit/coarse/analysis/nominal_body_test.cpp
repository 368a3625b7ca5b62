// The nominal body beside a structure: what it shares with it, and what of its answers serves for a longer crack.
#include "coarse/analysis/nominal_body.hpp"

#include <gtest/gtest.h>

#include "coarse/elements/near_elements.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

/// Whether the nominal body has functions of its own.
class NominalBodyOf : public testing::Test {
protected:
    explicit NominalBodyOf(bool has_own = false) : own(has_own) {
        input.load.blocks = {{.cycles = 1, .max = 60.0, .min = 0.0}};
        input.fine.enrichment = Enrichment::None;
        input.growth.emplace().increment = 0.6;
        scene = with_or_without(refined_scene(input));
        still.far = far_elements(*scene, nothing());
        body.stand_on(still, false);
        whole = body.solve(*scene, {}, shared);
        const ElementSet zone = select_zone(*scene, body.largest_K());
        still = still_elements(*scene, zone, still);
        structure = timed_condense(*scene, zone, still, shared, effort);
    }
    std::unique_ptr<Structure> solve_longer_by(double by) {
        input.cracks[0].points.back().x() += by;
        longer = with_or_without(make_scene(input, scene->mesh));
        still = still_elements(*longer, select_zone(*longer, body.largest_K()), still);
        body.stand_on(still, true);
        return body.solve(*longer, {}, shared);
    }
    [[nodiscard]] std::unique_ptr<Scene> with_or_without(Scene made) const {
        if (!own) made.nominal.reset();
        return std::make_unique<Scene>(std::move(made));
    }
    [[nodiscard]] ElementSet nothing() const { return ElementSet(scene->mesh->elements.size()); }
    [[nodiscard]] double error_of_K() const {
        const double K = solve_nominal(*longer).tips.at(0).K_I;
        return std::abs(body.tips().at(0).K_I - K) / K;
    }

    /// What two stations of the crack tell.
    [[nodiscard]] TipResult K_of(double pressure, double shear, bool in_wake, double load) const {
        const coupling::FaceSample mouth{.s = 0.1, .pressure = pressure, .shear = shear, .in_wake = in_wake};
        coupling::FaceSample ahead = mouth;
        ahead.s = 7.0;
        return body.K_of_faces(*scene, load, tractions_of({mouth, ahead}), shared).at(0);
    }

    const bool own;
    const Note silent = [](const std::string&) {};
    CoarseEffort effort;
    Case input = test::pulled_plate(0.5, true, false);
    StructureFactors shared;
    StillElements still;
    std::unique_ptr<Scene> scene, longer;
    NominalBody body{effort, silent};
    std::unique_ptr<Structure> whole, structure;
};

TEST_F(NominalBodyOf, WholeMeshIsKnownOnceAndThenWhatIsNearTheTips) {
    ASSERT_TRUE(whole);
    EXPECT_EQ(body.displacement().size(), scene->enriched.unknowns);
    const auto far = effort.work.far_factorisations;
    EXPECT_TRUE(solve_longer_by(0.6));
    EXPECT_EQ(body.displacement().size(), 0);
    EXPECT_LT(error_of_K(), 1e-9);
    EXPECT_NEAR(body.grown(), 0.6, 1e-12);
    EXPECT_EQ(effort.work.far_factorisations, far) << "the structure has it";
}

TEST_F(NominalBodyOf, HandsItsRingsOutOnce) {
    EXPECT_EQ(body.take_rings(nothing()).size(), 1U);
    EXPECT_TRUE(body.take_rings(nothing()).empty());
}

TEST_F(NominalBodyOf, WhatIsBehindTheTipsStaysAsLongAsItsFunctionsDo) {
    ElementSet mouth = nothing(), tip = nothing();
    mouth.insert(scene->enriched.pieces.front().element);
    for (const CrackPiece& piece : scene->enriched.pieces) tip.insert(piece.element);
    (void)solve_longer_by(0.6);
    body.put_behind(mouth);
    body.keep_behind(*scene, *longer);
    EXPECT_TRUE(body.has_behind());
    body.put_behind(tip);
    body.keep_behind(*scene, *longer);
    EXPECT_FALSE(body.has_behind());
}

class NominalBodyWithFunctions : public NominalBodyOf {
protected:
    NominalBodyWithFunctions() : NominalBodyOf(true) {}
};

// No function stands in the zone: its crack ends on an edge, up to half an element off, and K with it.
TEST_F(NominalBodyWithFunctions, FollowsTheTipThroughItsElement) {
    ASSERT_TRUE(scene->nominal);
    EXPECT_FALSE(whole) << "the structure has other functions";
    EXPECT_EQ(body.displacement().size(), scene->enriched.unknowns);
    const auto far = effort.work.far_factorisations;
    double last = body.tips().at(0).K_I;
    for (int step = 0; step < 6; ++step) {
        EXPECT_FALSE(solve_longer_by(0.1));
        EXPECT_LT(error_of_K(), 1e-9);
        const double K = body.tips().at(0).K_I;
        EXPECT_NEAR(K / last - 1.0, 0.0184, 0.001) << step;
        last = K;
    }
    EXPECT_EQ(effort.work.far_factorisations, far) << "it stands on that of the structure";
    EXPECT_TRUE(body.take_rings(nothing()).empty()) << "of other unknowns";
}

// Bueckner: K of a load is that of faces that bear what the load does there in a body without a crack, turned round.
TEST_F(NominalBodyWithFunctions, HasTheKOfTractionsOnItsFaces) {
    const TipResult pulled = body.tips().at(0);
    const TipResult pressed = K_of(2.0, 0.0, false, 1.0);
    EXPECT_NEAR(pressed.K_I / (2.0 * pulled.K_I), 1.0, 2e-3);
    EXPECT_NEAR(pressed.K_II, 2.0 * pulled.K_II, 2e-3 * pulled.K_I);
    const TipResult braked = K_of(0.0, 1.0, true, 1.0);
    EXPECT_LT(braked.K_II, -0.5 * pulled.K_I);
    EXPECT_NEAR(braked.K_I, 0.0, 0.02 * pulled.K_I);
}

// The load opens a wake that presses: a wedge, which is no load. Where the load presses them together they bear it.
TEST_F(NominalBodyWithFunctions, LeavesWedgesOut) {
    const double K = body.tips().at(0).K_I;
    EXPECT_EQ(K_of(2.0, 0.0, true, 1.0).K_I, 0.0);
    EXPECT_NEAR(K_of(2.0, 0.0, true, -1.0).K_I / (2.0 * K), 1.0, 2e-3);
}

}  // namespace
}  // namespace stria::coarse
