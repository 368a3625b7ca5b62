// What follows from several keys of a case.
#include "common/case/case_questions.hpp"

#include <gtest/gtest.h>

namespace stria {
namespace {

TEST(CaseQuestions, FacesTouchWhereTheirCrackHasContact) {
    const CrackSection free{.points = {}, .contact = {}}, touching{.points = {}, .contact = ContactSection{}};
    const CrackSection rough{.points = {}, .contact = ContactSection{.friction = 0.1}};
    EXPECT_FALSE(may_touch(free));
    EXPECT_TRUE(may_touch(touching));
    EXPECT_FALSE(some_touch({}));
    EXPECT_FALSE(some_touch({free, free}));
    EXPECT_TRUE(some_touch({free, touching}));
    EXPECT_FALSE(has_friction({free, touching}));
    EXPECT_TRUE(has_friction({touching, rough}));
}

TEST(CaseQuestions, LawsThatOpeningsDrive) {
    for (const GrowthLaw law : {GrowthLaw::Prescribed, GrowthLaw::Paris, GrowthLaw::Table, GrowthLaw::Ctod}) {
        for (const GrowthDriving driving :
             {GrowthDriving::Range, GrowthDriving::FullRange, GrowthDriving::EffectiveRange}) {
            GrowthSection growth;
            growth.law = law;
            growth.driving = driving;
            const bool of_range = law == GrowthLaw::Paris || law == GrowthLaw::Table;
            const bool by_loads = of_range && driving == GrowthDriving::EffectiveRange;
            EXPECT_EQ(is_prescribed(growth), law == GrowthLaw::Prescribed);
            EXPECT_EQ(is_law_of_dK(growth), of_range);
            EXPECT_EQ(grows_by_opening_loads(growth), by_loads);
            EXPECT_EQ(grows_by_openings(growth), by_loads || law == GrowthLaw::Ctod);
        }
    }
}

TEST(CaseQuestions, AZoneIsOfMetalThatYieldsFacesThatTouchSmallElementsOrAForceAheadOfATip) {
    Case plain;
    plain.cracks = {{.points = {}, .contact = {}}};
    EXPECT_FALSE(needs_fine(plain));
    Case input = plain;
    input.regions.emplace_back().material.yield_stress = 300.0;
    EXPECT_TRUE(may_yield(input));
    EXPECT_TRUE(needs_fine(input));
    input = plain;
    input.cracks.push_back({.points = {}, .contact = ContactSection{}});
    EXPECT_TRUE(needs_fine(input));
    input = plain;
    input.fine.refine = 2;
    EXPECT_TRUE(needs_fine(input));
    input = plain;
    input.fine.radius = 1.0;
    EXPECT_TRUE(needs_fine(input));
    input = plain;
    input.closure.tension = true;
    EXPECT_TRUE(needs_fine(input));
    input.cracks.clear();
    EXPECT_FALSE(needs_fine(input)) << "no tip";
    input = plain;
    input.closure.definition = OpeningDefinition::Tension;
    EXPECT_TRUE(needs_fine(input));
}

}  // namespace
}  // namespace stria
