// What is said of a case before it is run.
#include "coarse/advice/case_warnings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "coarse/zone/refined_scene.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

const std::vector<Vec2> from_mouth{{0.0, 10.13}, {4.0, 10.13}}, from_tip{{4.0, 10.13}, {0.0, 10.13}};

/// A crack with a notch whose faces may touch in elements of 0.5 mm.
Case notched(double notch, double grown_at_start, const std::vector<Vec2>& points) {
    Case input = specimen("plate", 20.0, points);
    input.mesh.width = 10.0;
    input.mesh.size = 0.5;
    input.material.yield_stress = 250.0;
    input.cracks[0].contact.emplace();
    input.cracks[0].notch = notch;
    input.cracks[0].grown_at_start = grown_at_start;
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load.blocks = {{.cycles = 2, .max = 60.0, .min = -60.0}};
    return input;
}

/// What holds these words of all that is said; empty: nothing does.
std::string said_of(const Case& input, const std::string& words) {
    const coarse::Scene scene = coarse::refined_scene(input);
    const std::size_t tips = scene.enriched.tips.size();
    const std::vector<std::string> all =
        coarse::case_warnings(scene, {.K_I = std::vector<double>(tips, 5.0), .K_II = std::vector<double>(tips, 0.0)});
    const auto found =
        std::ranges::find_if(all, [&](const std::string& text) { return text.find(words) != text.npos; });
    return found != all.end() ? *found : "";
}

/// That nothing touches where closure is looked at.
std::string nothing_touches(double distance, double notch, double grown_at_start = 0.0,
                            const std::vector<Vec2>& points = from_mouth, bool grows = false) {
    Case input = notched(notch, grown_at_start, points);
    input.closure.distance = distance;
    if (grows) input.growth = GrowthSection{.increment = 0.1};
    return said_of(input, "nothing touches");
}

/// That faces between a tip and a notch are pressed which no element can bend as they want.
std::string too_few_before_notch(double notch, const std::vector<Vec2>& points, double least_load = -60.0,
                                 bool grows = false) {
    Case input = notched(notch, 0.0, points);
    input.load.blocks[0].min = least_load;
    if (grows) input.growth = GrowthSection{.increment = 0.1};
    return said_of(input, "between it and the notch");
}

TEST(CaseWarnings, ClosureIsLookedAtWhereFacesMayTouch) {
    EXPECT_EQ(nothing_touches(0.5, 0.0), "");
    EXPECT_NE(nothing_touches(4.1, 0.0).find("end after 4 mm"), std::string::npos);
    EXPECT_EQ(nothing_touches(0.7, 3.2), "");
    EXPECT_NE(nothing_touches(0.9, 3.2).find("end after 0.8 mm"), std::string::npos) << nothing_touches(0.9, 3.2);
    EXPECT_NE(nothing_touches(0.7, 4.5).find("end after 0 mm"), std::string::npos) << nothing_touches(0.7, 4.5);
    EXPECT_EQ(nothing_touches(1.5, 1.0, 0.0, from_tip), "") << "beyond the notch faces may touch";
    EXPECT_EQ(nothing_touches(0.7, 3.0, 0.5), "") << "nor beyond one that stays";
    EXPECT_NE(nothing_touches(4.1, 3.0, 0.5).find("end after 4 mm"), std::string::npos)
        << nothing_touches(4.1, 3.0, 0.5);
}

// A crack that starts from its notch: the faces that it grows may touch.
TEST(CaseWarnings, ClosureIsLookedAtWhereFacesWillTouch) {
    const std::string all = nothing_touches(0.7, 4.5), until = nothing_touches(0.7, 4.5, 0.0, from_mouth, true);
    EXPECT_NE(all.find("open all the cycle (closure.distance)"), std::string::npos) << all;
    EXPECT_NE(until.find("open all the cycle until it has grown by 0.7 mm (closure.distance)"), std::string::npos)
        << until;
}

TEST(CaseWarnings, FacesBeforeANotchAreTooShortToBePressed) {
    const std::string said = too_few_before_notch(3.2, from_mouth);
    EXPECT_NE(said.find("only 0.8 mm of faces that may touch, 1.6 elements of 0.5 mm"), std::string::npos) << said;
    EXPECT_NE(said.find("nominal K_I of -300 MPa"), std::string::npos) << said;
    EXPECT_NE(said.find("elements of 0.46 mm there, or crack.0.notch = 3.125"), std::string::npos) << said;
    EXPECT_NE(too_few_before_notch(3.98, from_mouth), "");
    EXPECT_NE(too_few_before_notch(3.2, from_mouth, -60.0, true).find("until it has grown by 0.075 mm"),
              std::string::npos);
    EXPECT_EQ(too_few_before_notch(3.1, from_mouth), "") << "elements enough";
    EXPECT_EQ(too_few_before_notch(3.2, from_mouth, 0.0), "") << "nothing presses";
    EXPECT_EQ(too_few_before_notch(0.0, from_mouth), "") << "no notch";
    EXPECT_EQ(too_few_before_notch(4.0, from_mouth), "") << "nothing before it touches";
    EXPECT_EQ(too_few_before_notch(1.0, from_tip), "") << "the tip is in the notch";
}

// K_I alone says that the law drives no tip; behind its turn it does.
TEST(CaseWarnings, WhatDrivesATipThatTurnsIsThatBehindItsTurn) {
    Case input = notched(0.0, 0.0, from_mouth);
    input.load.blocks = {{.cycles = 9, .max = 60.0, .min = 0.0}};
    input.growth = GrowthSection{.law = GrowthLaw::Paris, .increment = 0.1, .C = 1e-12, .m = 3.0};
    const coarse::UnitResponse turns{.K_I = {2.0}, .K_II = {5.0}}, straight{.K_I = {2.0}, .K_II = {0.1}};
    const auto says = [&](const coarse::UnitResponse& nominal, double threshold) {
        input.growth->threshold = threshold;
        for (const std::string& text : coarse::case_warnings(coarse::refined_scene(input), nominal))
            if (text.find("no growth by a dK below") != text.npos) return text;
        return std::string();
    };
    EXPECT_NE(says(straight, 200.0).find("no tip is larger than 120"), std::string::npos) << says(straight, 200.0);
    EXPECT_EQ(says(turns, 200.0), "");
    EXPECT_NE(says(turns, 500.0).find("no tip is larger than 4"), std::string::npos) << says(turns, 500.0);
    input.growth->direction = GrowthDirection::Straight;
    EXPECT_NE(says(turns, 200.0), "");
}

// One overload of twice the load: four times the distance for all cycles, if nobody gives one.
TEST(CaseWarnings, ADistanceThatGoesByAnOverloadIsSaid) {
    Case input = notched(0.0, 0.0, from_mouth);
    input.growth = GrowthSection{.increment = 0.1};
    const auto said = [&](std::vector<LoadBlock> blocks) {
        input.load.blocks = std::move(blocks);
        return said_of(input, "by the largest K");
    };
    const LoadBlock usual{.cycles = 9, .max = 60.0, .min = 0.0}, overload{.cycles = 1, .max = 120.0, .min = 0.0};
    EXPECT_EQ(said({usual}), "");
    const std::string all = said({usual, overload, usual});
    EXPECT_NE(all.find("600 MPa sqrt(mm); by the usual 300 it would be 0.028 mm"), std::string::npos) << all;
    input.closure.distance = 0.1;
    EXPECT_EQ(said({usual, overload, usual}), "");
    input.closure.distance.reset();
    input.material.yield_stress.reset();
    EXPECT_EQ(said({usual, overload, usual}), "") << "zero by either K where nothing yields";
}

// A compliance wants a mouth, and increments of a tenth of the load range.
TEST(CaseWarnings, WhereNoComplianceOffsetCanBeToldIsSaid) {
    Case input = notched(0.0, 0.0, from_mouth);
    input.closure.definition = OpeningDefinition::Offset;
    const auto said = [&](int steps, double grading) {
        input.load.steps = steps;
        input.load.grading = grading;
        return said_of(input, "\"offset\"");
    };
    EXPECT_EQ(said(40, 1.0), "");
    EXPECT_EQ(said(20, 1.0), "") << "a tenth, but for rounding";
    EXPECT_NE(said(12, 1.0).find("no K_op is told; load.steps = 40"), std::string::npos) << said(12, 1.0);
    EXPECT_NE(said(40, 0.6).find("of a crack that opens below 0.17 of the way up"), std::string::npos) << said(40, 0.6);
    input.cracks[0].points = {{3.0, 10.13}, {7.0, 10.13}};
    EXPECT_NE(said(40, 1.0).find("tip 0: its crack has two tips"), std::string::npos) << said(40, 1.0);
    input.closure.definition = OpeningDefinition::Tension;
    EXPECT_EQ(said(40, 1.0), "");
}

TEST(CaseWarnings, FacesThatATipLeavesBeforeItsNotchAreTooShortToBePressed) {
    const auto said = [](double notch, const std::vector<Vec2>& points, double least, bool grows) {
        Case input = notched(notch, 0.0, points);
        input.load.blocks[0].min = least;
        if (grows) input.growth = GrowthSection{.increment = 0.1};
        return said_of(input, "it starts where its notch ends");
    };
    for (const double notch : {4.0, 4.0 - 1e-9}) {
        const std::string found = said(notch, from_mouth, -60.0, true);
        EXPECT_NE(found.find("tip 0: it starts where its notch ends, and the load presses the faces that it leaves "
                             "between it and the notch with a nominal K_I of -300 MPa"),
                  std::string::npos)
            << found;
        EXPECT_NE(found.find("until it has grown by 0.875 mm: crack.0.notch = 3.125"), std::string::npos) << found;
    }
    EXPECT_NE(said(1.0, from_tip, -60.0, true).find("by 0.875 mm"), std::string::npos);
    EXPECT_EQ(said(1.0, from_tip, -60.0, true).find("crack.0.notch"), std::string::npos) << "a shorter one is no help";
    EXPECT_EQ(said(4.0, from_mouth, -60.0, false), "") << "it is free all along";
    EXPECT_EQ(said(4.0, from_mouth, 0.0, true), "") << "nothing presses";
    EXPECT_EQ(said(3.0, from_mouth, -60.0, true), "") << "elements enough";
}

// Metal that flows; an elastic body needs no more than two.
TEST(CaseWarnings, FewIncrementsOfMetalThatFlowsAreSaid) {
    Case input = specimen("plate", 20.0, from_mouth);
    input.mesh.width = 10.0;
    input.mesh.size = 0.5;
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load.blocks = {{.cycles = 2, .max = 60.0, .min = 0.0}};
    const auto said = [&](std::optional<double> yield_stress, OrAuto<int> steps) {
        input.material.yield_stress = yield_stress;
        input.load.steps = steps;
        for (const std::string& text :
             coarse::case_warnings(coarse::refined_scene(input), {.K_I = {5.0}, .K_II = {0.0}}))
            if (text.starts_with("load.steps")) return text;
        return std::string();
    };
    EXPECT_NE(said(250.0, 2).find("load.steps = 2: metal that flows is taken from one reversal to the next in one inc"),
              std::string::npos);
    EXPECT_NE(said(250.0, 6).find("in 3 increments"), std::string::npos);
    EXPECT_EQ(said(250.0, 8), "");
    EXPECT_EQ(said(250.0, {}), "");
    EXPECT_EQ(said({}, 2), "");
}

}  // namespace
}  // namespace stria::test
