// Whether a mesh is fine enough for opening loads and growth.
#include "coarse/advice/opening_adequacy.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coarse/fracture/plastic_zone.hpp"
#include "coarse/specimen/specimen.hpp"
#include "tests/support/advice.hpp"

namespace stria::test {
namespace {

TEST_F(Advice, NamesTheRefinementThatWouldDo) {
    const auto warnings = at(600.0);  // 0.63 mm
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].find("about 0.628 mm, spans 0.63 elements of 1 mm"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find("fine.refine = 8"), std::string::npos) << warnings[0];
    EXPECT_TRUE(at(2100.0).empty());  // 7.7 mm
}

// In plane strain metal flows to the sides, four times as far as ahead; a wake is of what has flowed ahead.
TEST_F(Advice, MindsTheFlowAheadOfATipThatGrows) {
    input.growth = GrowthSection{.increment = 0.5};
    const auto warnings = at(2100.0);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].find("about 1.96 mm ahead of it, spans 2 elements of 1 mm"), std::string::npos)
        << warnings[0];
    EXPECT_NE(warnings[0].find("fine.refine = 4"), std::string::npos) << warnings[0];
    EXPECT_TRUE(at(3400.0).empty());  // 5.1 mm
    input.model.plane = PlaneState::Stress;
    EXPECT_EQ(at(1650.0).size(), 1U);  // 9.6 mm
    EXPECT_TRUE(at(1700.0).empty());   // 10.2 mm
}

TEST_F(Advice, NamesNoRefinementThatIsNotAllowed) {
    const auto warnings = at(5.0);  // 0.000044 mm: 2^17 would do
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].find("5 or more, which no fine.refine gives: hardly anything yields"), std::string::npos)
        << warnings[0];
}

TEST_F(Advice, IsNotGivenToWhoAsksForNoOpeningLoads) {
    input.cracks[0].contact.reset();
    EXPECT_TRUE(at(600.0).empty());
    input.cracks[0].contact = ContactSection{};
    input.material.yield_stress.reset();
    EXPECT_TRUE(at(600.0).empty());
}

// Elements of 1 mm. With one and a part at a time now one opens, and now two.
TEST_F(Advice, MindsHowFarTheCrackGrowsAtATime) {
    for (const double increment : {0.7, 1.0, 1.04, 1.96}) {
        input.growth = GrowthSection{.increment = increment};
        EXPECT_TRUE(at(3400.0).empty()) << increment;
    }
    for (const double increment : {1.2, 1.9, 2.0, 2.5}) {
        input.growth->increment = increment;
        const auto warnings = at(3400.0);
        ASSERT_EQ(warnings.size(), 1U) << increment;
        EXPECT_NE(warnings[0].find(fmt::format("crosses {:g} elements of 1 mm", increment)), std::string::npos)
            << warnings[0];
    }
    input.growth->increment = 1.04;
    input.load.blocks = {{.cycles = 30, .max = 1.0}};
    ASSERT_EQ(at(3400.0).size(), 1U) << "two elements in one growth of 25";
    EXPECT_NE(at(3400.0)[0].find("crosses 1.04 elements of 1 mm"), std::string::npos) << at(3400.0)[0];
    EXPECT_NE(at(3400.0)[0].find(": growth.increment = 1 or less, or elements of 1.04 mm or more"), std::string::npos)
        << at(3400.0)[0];
    input.growth->every = 3;
    EXPECT_TRUE(at(3400.0).empty());
}

// Of elements of 0.5 x 0.976 mm, whose diagonal is that of a square of 0.775 mm, it is the length along the crack.
TEST_F(Advice, CountsTheElementsThatGrowthCrossesAlongTheCrack) {
    input.mesh.grading = {
        {.at = {{0.0, 1.0}, {20.0, 1.0}}, .size = 0.5, .outer_size = 0.5, .radius = 0.0, .growth = 0.5}};
    const auto crosses = [&](double increment) {
        input.growth = GrowthSection{.increment = increment};
        for (const std::string& warning : at(3400.0))
            if (const auto found = warning.find("crosses "); found != std::string::npos)
                return warning.substr(found, warning.find(" at a time") - found);
        return std::string("whole ones");
    };
    EXPECT_EQ(crosses(0.5), "whole ones");
    EXPECT_EQ(crosses(0.79), "crosses 1.58 elements of 0.5 mm");
    input.cracks[0].points = {{8.3, 20.0}, {8.3, 11.7}};
    EXPECT_EQ(crosses(1.0), "whole ones");
    EXPECT_EQ(crosses(1.2), "crosses 1.23 elements of 0.976 mm");
    input.cracks[0].points = {{8.3, 20.0}, {9.3, 12.0}};  // steep: from row to row
    EXPECT_EQ(crosses(std::hypot(1.0, 0.125)), "whole ones");
    EXPECT_EQ(crosses(1.25), "crosses 1.27 elements of 0.984 mm");
}

// A tenth of 10.2 mm in plane stress; in plane strain nothing is seen of it.
TEST_F(Advice, MindsHowMuchOfItsZoneTheCrackGrowsAtATime) {
    input.model.plane = PlaneState::Stress;
    input.growth = GrowthSection{.increment = 1.0};
    EXPECT_TRUE(at(1700.0).empty());
    input.growth->increment = 1.04;
    EXPECT_TRUE(at(1700.0).empty()) << "no more than the distance";
    closure_at = 1.0;
    const auto warnings = at(1700.0);
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_NE(warnings[1].find("1.04 mm is 0.1 of its forward plastic zone, about 10.2 mm"), std::string::npos)
        << warnings[1];
    EXPECT_NE(warnings[1].find("growth.increment = 1, or"), std::string::npos) << warnings[1];
    input.model.plane = PlaneState::Strain;
    EXPECT_EQ(at(3400.0).size(), 1U) << "of the distance";
}

TEST_F(Advice, SaysThatALifeByClosureInPlaneStrainEndsSooner) {
    input.mesh.size = 0.25;
    input.growth.emplace().increment = 0.25;
    const auto says = [&](GrowthLaw law, GrowthDriving driving, PlaneState plane) {
        input.growth->law = law;
        input.growth->driving = driving;
        input.model.plane = plane;
        return std::ranges::any_of(
            at(2000.0), [](const std::string& said) { return said.find("life is too long") != std::string::npos; });
    };
    EXPECT_TRUE(says(GrowthLaw::Paris, GrowthDriving::EffectiveRange, PlaneState::Strain));
    EXPECT_TRUE(says(GrowthLaw::Ctod, GrowthDriving::Range, PlaneState::Strain));
    EXPECT_FALSE(says(GrowthLaw::Paris, GrowthDriving::EffectiveRange, PlaneState::Stress));
    EXPECT_FALSE(says(GrowthLaw::Paris, GrowthDriving::Range, PlaneState::Strain));
    EXPECT_FALSE(says(GrowthLaw::Prescribed, GrowthDriving::EffectiveRange, PlaneState::Strain));
    input.cracks[0].contact.reset();
    EXPECT_FALSE(says(GrowthLaw::Ctod, GrowthDriving::Range, PlaneState::Strain));
}

// Elements of 1 mm in a zone of 12.7 mm; K at which a tip looks is the usual one.
TEST_F(Advice, SaysByHowMuchALifeByOpeningLoadsInPlaneStressIsTooLong) {
    input.model.plane = PlaneState::Stress;
    input.growth.emplace().increment = 1.0;
    input.growth->law = GrowthLaw::Paris;
    input.growth->driving = GrowthDriving::EffectiveRange;
    input.growth->m = 4.0;
    closure_at = 1.21;
    const auto says = [&] {
        const auto warnings = at(1896.0);
        return warnings.empty() ? std::string() : warnings[0];
    };
    EXPECT_NE(says().find("0.079 of the forward plastic zone, is too long by up to about 63 %"), std::string::npos)
        << says();
    EXPECT_NE(says().find("(fine.refine = 2)"), std::string::npos) << says();
    input.growth->m = 2.0;
    EXPECT_NE(says().find("31 %"), std::string::npos) << says();
    input.growth->m = 0.15;
    EXPECT_EQ(says(), "") << "by 2 %";
    input.growth->m = 4.0;
    input.closure.definition = OpeningDefinition::Offset;
    EXPECT_EQ(says(), "") << "not measured";
    input.closure.definition = OpeningDefinition::Contact;
    closure_at = 1.1;
    EXPECT_EQ(says().find("too long"), std::string::npos) << "two such meshes lead nowhere";
    closure_at = 1.21;
    input.growth->driving = GrowthDriving::Range;
    EXPECT_EQ(says(), "");
    input.growth->driving = GrowthDriving::EffectiveRange;
    input.cracks[0].contact.reset();
    EXPECT_EQ(says(), "");
}

// Its opening loads and the distance want ten elements and 1.2.
TEST_F(Advice, SaysWhatTooFewElementsDoToALifeByOpeningLoads) {
    input.model.plane = PlaneState::Stress;
    input.growth.emplace().increment = 1.0;
    input.growth->law = GrowthLaw::Paris;
    const auto say = [&](GrowthDriving driving, double K_I) {
        input.growth->driving = driving;
        return std::ranges::count_if(at(K_I), [](const std::string& said) { return said.ends_with("75 % longer"); });
    };
    EXPECT_EQ(say(GrowthDriving::EffectiveRange, 1700.0), 0);
    EXPECT_EQ(say(GrowthDriving::EffectiveRange, 1500.0), 1);
    EXPECT_EQ(say(GrowthDriving::Range, 1500.0), 0);
    closure_at = 1.0;
    EXPECT_EQ(say(GrowthDriving::EffectiveRange, 1500.0), 2);
    input.model.plane = PlaneState::Strain;
    EXPECT_EQ(say(GrowthDriving::EffectiveRange, 1500.0), 0) << "not measured";
}

// Elements of 1 mm: what is read nearer than the second is the opening of the tip's own.
TEST_F(Advice, MindsHowManyElementsLieBetweenTheTipAndWhereClosureIsLookedAt) {
    closure_at = 1.21;
    EXPECT_TRUE(at(2100.0).empty());
    closure_at = 0.3;
    const auto warnings = at(2100.0);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].find("0.3 mm behind it, 0.3 elements of 1 mm"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find("fine.refine = 4, or closure.distance = 1.3"), std::string::npos) << warnings[0];
    input.mesh.size = 0.4;
    closure_at = 0.48;  // 1.2 of them, whose edges are rounded
    EXPECT_TRUE(at(2100.0).empty());
    input.mesh.size = 1.0;
    closure_at = 1e-5;  // 2^17 elements
    EXPECT_NE(at(2100.0).at(0).find("K_max off: closure.distance = 1.3"), std::string::npos) << at(2100.0)[0];
    input.material.yield_stress.reset();
    EXPECT_TRUE(at(2100.0).empty());
}

// By a fixed distance K_op / K_max fell from .42 to .34 in a test of falling K, and was read as closure that fades.
TEST_F(Advice, SaysThatKHasFallenBelowTheDistanceOfClosure) {
    const auto fallen = [&](double from, std::vector<double> to) {
        input.growth = GrowthSection{.law = GrowthLaw::Prescribed, .increment = 1.0};
        const coarse::Scene scene =
            coarse::make_scene(input, BodyMesh(coarse::make_mesh(input.mesh, input.cracks, input.regions)));
        const double distance =
            coarse::closure_distances(ClosureSection(), {2100.0}, scene.yield_stress_at_tips()).front();
        coarse::MeshJudge judge;
        const auto look = [&](double K) {
            return judge.look_at(scene, {.K_I = {K}, .distance = {distance}, .radius = {5.0}});
        };
        for (const std::string& said : look(from)) EXPECT_EQ(said.find("has fallen"), std::string::npos);
        std::vector<std::string> about;
        for (const double K : to)
            for (const std::string& said : look(K))
                if (said.find("has fallen") != std::string::npos) about.push_back(said);
        return about;
    };
    const auto said = fallen(2100.0, {1750.0, 1700.0, 1600.0, 1190.0});
    ASSERT_EQ(said.size(), 2U);
    EXPECT_NE(said[0].find("has fallen to 1700"), std::string::npos) << said[0];
    EXPECT_NE(said[0].find("1.5 times as far"), std::string::npos) << said[0];
    EXPECT_NE(said[1].find("has fallen to 1190"), std::string::npos) << said[1];
    EXPECT_TRUE(fallen(1400.0, {1400.0}).empty()) << "of an overload it was told at the start";
    input.closure.distance = 1.3;
    EXPECT_TRUE(fallen(2100.0, {1000.0}).empty());
    input.closure.distance.reset();
    input.cracks[0].contact.reset();
    EXPECT_TRUE(fallen(2100.0, {1000.0}).empty());
}

// Elastic metal beside some that may yield. A body of which nothing may leaves nothing behind.
TEST_F(Advice, NamesWhatATipInElasticMetalLeavesBehind) {
    input.regions = {{.outline = {{12.0, -1.0}, {41.0, 41.0}}, .material = input.material, .initial_stress = {}}};
    input.material.yield_stress.reset();
    input.growth = GrowthSection{.increment = 0.5};
    const auto warnings = at(600.0);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].find("\"none\" leaves nothing behind, and so do elements below 0.166 mm"), std::string::npos)
        << warnings[0];
    input.growth->retain = Retain::All;
    EXPECT_NE(at(600.0).at(0).find("\"all\" is for comparison"), std::string::npos) << at(600.0)[0];
    input.growth->retain = Retain::Frozen;
    input.fine.enrichment = Enrichment::None;
    EXPECT_TRUE(at(600.0).empty());
    input.fine.enrichment = Enrichment::Auto;
    input.mesh.size = 0.15;
    EXPECT_TRUE(at(600.0).empty()) << "they bear no function";
    input.mesh.size = 1.0;
    input.regions.clear();
    EXPECT_TRUE(at(600.0).empty()) << "it forgets";
    input.cracks[0].contact.reset();
    EXPECT_TRUE(at(600.0).empty());
}

}  // namespace
}  // namespace stria::test
