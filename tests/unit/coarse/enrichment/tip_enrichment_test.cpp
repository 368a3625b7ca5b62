// Eq. (2): what fine.enrichment = "auto" chooses.
#include "coarse/enrichment/tip_enrichment.hpp"

#include <gtest/gtest.h>

namespace stria::coarse {
namespace {

// docs/enrichment.md: r^(1/(n+1)) where the metal hardens by a power law and nothing else, and no crack grows.
TEST(TipEnrichment, ThePowerOfTheFunctionsIsThatOfTheMaterial) {
    Case input;
    input.material.yield_stress = 300.0;
    EXPECT_EQ(choose_enrichment(input).exponent, 0.5);
    input.material.isotropic = {.law = HardeningLaw::Power, .n = 4.0, .alpha = 1.0};
    EXPECT_EQ(choose_enrichment(input).functions, 1);
    EXPECT_EQ(choose_enrichment(input).exponent, 0.2);
    input.material.kinematic.push_back({.C = 1000.0});
    EXPECT_EQ(choose_enrichment(input).exponent, 0.5);
    input.fine.enrichment_n = 9.0;
    EXPECT_EQ(choose_enrichment(input).exponent, 0.1);
    input.fine.enrichment_n = {};
    input.material.kinematic.clear();
    input.growth = GrowthSection{};
    EXPECT_EQ(choose_enrichment(input).exponent, 0.5);
}

Case elastic_case() {
    Case input;
    input.cracks.resize(1);
    return input;
}

TEST(TipEnrichment, SpansTheElasticFieldsOverADiskWhereNothingIsToFlowOrTouch) {
    Case input = elastic_case();
    input.fine.enrichment_radius = 3.0;
    const TipEnrichment tips = choose_enrichment(input);
    EXPECT_EQ(tips.functions, 4);
    EXPECT_EQ(tips.support, TipSupport::Gathered);
    EXPECT_EQ(tips.radius, 3.0);
    EXPECT_EQ(tips.most_diagonals, 20.0);
}

TEST(TipEnrichment, ReachesOverTwoElementsInAnElasticZone) {
    Case touching = elastic_case(), rubbing = touching, growing = touching, refined = touching;
    touching.cracks[0].contact = ContactSection{};
    rubbing.cracks[0].contact = ContactSection{.friction = 0.3};
    growing.cracks[0].contact = ContactSection{};
    growing.growth = GrowthSection{};  // it leaves nothing behind
    refined.fine.refine = 2;
    for (const Case& input : {touching, rubbing, growing, refined}) {
        const TipEnrichment tips = choose_enrichment(input);
        EXPECT_EQ(tips.functions, 4);
        EXPECT_EQ(tips.support, TipSupport::Nodal);
        EXPECT_EQ(tips.most_diagonals, 1.6);
        EXPECT_EQ(tips.none_below, 0.0);
        EXPECT_FALSE(tips.radius);
    }
}

TEST(TipEnrichment, IsOneFunctionInMetalThatMayFlow) {
    Case input = elastic_case();
    input.material.yield_stress = 300.0;
    input.cracks[0].contact = ContactSection{.friction = 0.3};
    EXPECT_EQ(choose_enrichment(input).functions, 1);
    EXPECT_EQ(choose_enrichment(input).none_below, 0.0);
    input.growth = GrowthSection{};
    EXPECT_EQ(choose_enrichment(input).functions, 1);
    EXPECT_EQ(choose_enrichment(input).none_below, small_elements);
}

// What functions leave on the faces moves opening loads. Without contact there are none, and elastic bodies forget.
TEST(TipEnrichment, IsNoneWhereOpeningLoadsDriveGrowth) {
    Case input = elastic_case();
    input.cracks[0].contact = ContactSection{};
    input.growth = GrowthSection{.law = GrowthLaw::Paris, .driving = GrowthDriving::EffectiveRange};
    EXPECT_EQ(choose_enrichment(input).functions, 4);
    input.cracks[0].contact.reset();
    input.material.yield_stress = 300.0;
    EXPECT_EQ(choose_enrichment(input).functions, 1);
    input.cracks[0].contact = ContactSection{};
    EXPECT_EQ(choose_enrichment(input).functions, 0);
    input.growth->driving = GrowthDriving::Range;
    EXPECT_EQ(choose_enrichment(input).functions, 1);
}

TEST(TipEnrichment, IsWhatTheCaseNames) {
    Case input = elastic_case();
    input.material.yield_stress = 300.0;
    input.growth = GrowthSection{};
    input.fine.enrichment = Enrichment::None;
    EXPECT_EQ(choose_enrichment(input).functions, 0);
    input.fine.enrichment = Enrichment::Single;
    EXPECT_EQ(choose_enrichment(input).functions, 1);
    EXPECT_EQ(choose_enrichment(input).none_below, 0.0);  // it stays, whatever the elements
    input.fine.enrichment = Enrichment::Topological;
    EXPECT_EQ(choose_enrichment(input).functions, 6);
    input.fine.enrichment = Enrichment::Geometrical;
    EXPECT_EQ(choose_enrichment(input).support, TipSupport::Gathered);
}

}  // namespace
}  // namespace stria::coarse
