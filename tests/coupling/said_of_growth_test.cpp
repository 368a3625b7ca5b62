// What a run says once its cracks have grown beyond what was said of the case at its start.
#include <gtest/gtest.h>

#include "coarse/advice/mesh_adequacy.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

std::vector<std::string> notes_with(const std::vector<std::string>& notes, const std::string& words) {
    std::vector<std::string> found;
    for (const std::string& note : notes)
        if (note.find(words) != std::string::npos) found.push_back(note);
    return found;
}

/// Two edge cracks on one line, whose tips approach each other.
Case approaching() {
    Case input = specimen("plate", 20.0, {{0.0, 10.1}, {6.2, 10.1}});
    input.mesh.width = 20.0;
    input.mesh.size = 0.5;
    input.cracks.push_back(input.cracks[0]);
    input.cracks[1].points = {{20.0, 10.1}, {13.8, 10.1}};
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load = {.steps = 2, .blocks = {{.cycles = 8, .max = 90.0, .min = 0.0}}};
    input.growth = GrowthSection{.increment = 0.4};
    return input;
}

TEST(SaidOfGrowth, NamesATipThatHasNoRoomAnyMoreOnce) {
    const Case input = approaching();
    const coarse::Scene scene = coarse::refined_scene(input);
    EXPECT_TRUE(coarse::mesh_warnings(scene, {100.0, 100.0}, {1.0, 1.0}).empty()) << "there is room at the start";
    const std::vector<std::string> notes = run_direct(input).notes;
    for (const int tip : {0, 1}) {
        const std::vector<std::string> of_tip =
            notes_with(notes, fmt::format("warning: tip {}: the largest ring off edges", tip));
        ASSERT_EQ(of_tip.size(), 1U) << tip;
        EXPECT_NE(of_tip[0].find("elements of 0.5 mm; K and J want 3 or more"), std::string::npos) << of_tip[0];
    }
}

// They met in one node, at 9.8 and 10.2 mm of 20.
TEST(SaidOfGrowth, EndsBeforeCracksWithoutFunctionsMeet) {
    for (const double increment : {0.4, 0.5, 1.9}) {
        Case input = approaching();
        input.fine.enrichment = Enrichment::None;
        input.growth->increment = increment;
        input.load.blocks[0].cycles = 16;
        const RunHistory run = run_direct(input);
        EXPECT_EQ(notes_with(run.notes, "growth ends here: crack 1: near (10, ").size(), 1U) << increment;
        EXPECT_LT(run.increments.back().tips[0].a, 9.8) << increment;
    }
}

TEST(SaidOfGrowth, IsNotSaidAgainOfWhatWasSaidAtTheStart) {
    Case input = approaching();
    input.cracks[0].points[1].x() = 8.45;
    input.cracks[1].points[1].x() = 11.55;
    input.growth->increment = 0.1;
    input.load.blocks[0].cycles = 2;
    const coarse::Scene scene = coarse::refined_scene(input);
    EXPECT_EQ(coarse::mesh_warnings(scene, {100.0, 100.0}, {1.0, 1.0}).size(), 2U);
    const RunHistory run = run_direct(input);
    EXPECT_NEAR(run.increments.back().tips[0].a, 8.65, 1e-3);
    EXPECT_TRUE(notes_with(run.notes, "the largest ring").empty());
}

// The state remembers it.
TEST(SaidOfGrowth, IsNotSaidAgainByARunThatGoesOn) {
    const Case input = approaching();
    const coarse::Scene scene = coarse::refined_scene(input);
    std::vector<std::string> notes;
    coarse::Listener listener;
    listener.note = [&](const std::string& text) { notes.push_back(text); };
    listener.reached = [&](const coarse::LoadStep& step) { return !(step.ends_cycle && step.cycle == 7); };
    coarse::CondensedFactory first(nullptr, input), second(nullptr, input);
    coarse::FatigueAnalysis begun(scene, first, listener);
    begun.run();
    EXPECT_EQ(notes_with(notes, "the largest ring").size(), 2U);
    const coarse::AnalysisState state = begun.state();
    coarse::FatigueAnalysis ended(scene, second, listener, &state);
    ended.run();
    EXPECT_TRUE(ended.finished());
    EXPECT_EQ(notes_with(notes, "the largest ring").size(), 2U);
}

/// A crack that runs into a band of soft metal, which flows all at once where nobody asked for small elements yet.
Case towards_soft_metal() {
    Case input = specimen("plate", 20.0, {{0.0, 10.1}, {5.2, 10.1}});
    input.mesh.width = 20.0;
    input.mesh.size = 1.0;
    input.material.yield_stress = 300.0;
    input.material.kinematic = {{.C = 4000.0}};
    RegionSection band;
    band.outline = {{7.0, 0.0}, {9.0, 20.0}};
    band.material = input.material;
    band.material.yield_stress = 40.0;
    input.regions = {band};
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load = {.steps = 4, .blocks = {{.cycles = 8, .max = 45.0, .min = 0.0}}};
    input.growth = GrowthSection{.increment = 0.3, .direction = GrowthDirection::Straight};
    input.fine.refine = 8;
    return input;
}

// Once for each size, and not again by a run that goes on.
TEST(SaidOfGrowth, NamesATipThatHasComeToLargeElements) {
    Case input = towards_soft_metal();
    const coarse::Scene scene = coarse::refined_scene(input);
    std::vector<std::string> notes;
    coarse::Listener listener;
    listener.note = [&](const std::string& text) { notes.push_back(text); };
    listener.reached = [&](const coarse::LoadStep& step) { return !(step.ends_cycle && step.cycle == 7); };
    fine::FineModel fine(input), other_fine(input);
    coarse::CondensedFactory first(&fine, input), second(&other_fine, input);
    coarse::FatigueAnalysis begun(scene, first, listener);
    begun.run();
    const coarse::AnalysisState state = begun.state();
    EXPECT_EQ(notes_with(notes, "times as large as fine.refine asks for").size(), 3U);
    EXPECT_EQ(notes_with(notes, "tip 0 has come to elements of 0.25 mm, 2 times as large").size(), 1U);
    EXPECT_EQ(notes_with(notes, "tip 0 has come to elements of 1 mm, 8 times as large").size(), 1U);
    coarse::FatigueAnalysis ended(scene, second, listener, &state);
    ended.run();
    EXPECT_TRUE(ended.finished());
    EXPECT_EQ(notes_with(notes, "times as large as fine.refine asks for").size(), 3U);
    input.regions.clear();
    EXPECT_TRUE(notes_with(run_direct(input).notes, "times as large").empty()) << "small elements follow the tip";
}

// Elements of the start hold the distance of closure, those farther on do not.
TEST(SaidOfGrowth, NamesATipWhoseElementsHaveGrownBeyondItsDistanceOfClosureOnce) {
    Case input = towards_soft_metal();
    input.regions.clear();
    input.fine.refine = 1;
    input.mesh.grading = {{.at = {{5.2, 10.1}}, .size = 0.1, .outer_size = 0.1, .radius = 0.3, .growth = 0.4}};
    input.closure.distance = 0.25;
    const coarse::Scene scene = coarse::refined_scene(input);
    const auto closure = [](const std::vector<std::string>& notes) {
        return notes_with(notes, "tip 0: closure is looked at 0.25 mm behind it").size();
    };
    EXPECT_EQ(closure(coarse::mesh_warnings(scene, {300.0}, {0.25})), 0U);
    EXPECT_EQ(closure(run_direct(input).notes), 1U);
    input.material.yield_stress.reset();
    EXPECT_EQ(closure(run_direct(input).notes), 0U) << "nothing flows";
}

// Elements as small as the case asks for would hold it, but what has flowed is not split.
TEST(SaidOfGrowth, AdvisesNoRefinementThatCannotBe) {
    Case input = towards_soft_metal();
    input.closure.distance = 0.3;
    const std::vector<std::string> notes =
        notes_with(run_direct(input).notes, "tip 0: closure is looked at 0.3 mm behind it");
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].find("fine.refine"), std::string::npos) << notes[0];
    EXPECT_NE(notes[0].find("off: closure.distance = "), std::string::npos) << notes[0];
}

// J is left empty nearer than two elements to another metal, and K is off nearer than 0.3.
TEST(SaidOfGrowth, NamesATipThatHasComeCloseToAnotherMetal) {
    Case input = towards_soft_metal();
    input.fine.refine = 1;
    input.material.yield_stress.reset();
    input.regions[0].outline = {{7.0, 0.0}, {20.0, 20.0}};
    input.regions[0].material.yield_stress.reset();
    input.regions[0].material.young = 70e3;
    input.cracks[0].points[1].x() = 4.4;
    input.growth->increment = 0.5;
    input.load.blocks[0].cycles = 6;
    const coarse::Scene scene = coarse::refined_scene(input);
    const RunHistory run = run_direct(input);
    EXPECT_TRUE(notes_with(coarse::mesh_warnings(scene, {0.0}, {0.1}), "in its own metal").empty());
    EXPECT_EQ(notes_with(run.notes, "J wants 2 or more and is not told: smaller").size(), 1U);
    EXPECT_EQ(notes_with(run.notes, "J wants 2 or more and is not told, and K is off").size(), 1U);
}

/// A crack at a controlled K: its forward zone, 1.49 mm, spans twelve elements.
Case at_given_K() {
    Case input = towards_soft_metal();
    input.regions.clear();
    input.model.plane = PlaneState::Stress;
    input.load.control = Control::StressIntensity;
    input.load.blocks = {{.cycles = 3, .max = 650.0, .min = 0.0}};
    input.closure.distance = 0.2;
    input.growth->increment = 0.125;
    return input;
}

bool is_of_the_zone(const std::string& note) {
    return note.find("tip 0: its forward plastic zone") != std::string::npos;
}

// 650 exp(-2 * 0.125) MPa sqrt(mm), and 0.905 mm.
TEST(SaidOfGrowth, NamesATipWhoseZoneHasShrunkOnceAndNotAgainByARunThatGoesOn) {
    Case input = at_given_K();
    input.load.K_gradient = -2.0;
    const coarse::Scene scene = coarse::refined_scene(input);
    EXPECT_TRUE(coarse::mesh_warnings(scene, {650.0}, {0.2}).empty());
    std::vector<std::string> notes;
    coarse::Listener listener;
    listener.note = [&](const std::string& text) { notes.push_back(text); };
    listener.reached = [&](const coarse::LoadStep& step) { return !(step.ends_cycle && step.cycle == 2); };
    fine::FineModel fine(input), other_fine(input);
    coarse::CondensedFactory first(&fine, input), second(&other_fine, input);
    coarse::FatigueAnalysis begun(scene, first, listener);
    begun.run();
    const coarse::AnalysisState state = begun.state();
    ASSERT_EQ(std::ranges::count_if(notes, is_of_the_zone), 1);
    EXPECT_NE(std::ranges::find_if(notes, is_of_the_zone)->find("at K_I = 506.2 MPa sqrt(mm), about 0.906 mm"),
              std::string::npos)
        << *std::ranges::find_if(notes, is_of_the_zone);
    coarse::FatigueAnalysis ended(scene, second, listener, &state);
    ended.run();
    EXPECT_TRUE(ended.finished());
    EXPECT_EQ(std::ranges::count_if(notes, is_of_the_zone), 1);
}

// Cycles make half of the growth at 650, those that are left at 400.
TEST(SaidOfGrowth, NamesATipWhoseLoadHasFallen) {
    Case input = at_given_K();
    EXPECT_EQ(std::ranges::count_if(run_direct(input).notes, is_of_the_zone), 0);
    input.load.blocks = {{.cycles = 2, .max = 650.0, .min = 0.0}, {.cycles = 1, .max = 400.0, .min = 0.0}};
    EXPECT_EQ(std::ranges::count_if(run_direct(input).notes, is_of_the_zone), 1);
}

// Across the lines of a mesh the first multiplier beyond the distance of closure is now nearer and now farther.
TEST(SaidOfGrowth, NamesOpeningLoadsThatGoToAndFroOnceAndNotAgainByARunThatGoesOn) {
    Case input = at_given_K();
    input.cracks[0].points = {{0.0, 8.1}, {5.2, 12.5}};
    input.cracks[0].contact = ContactSection{};
    input.closure.distance = 0.15;
    input.load.steps = 12;
    input.load.blocks[0].cycles = 12;
    const coarse::Scene scene = coarse::refined_scene(input);
    std::vector<std::string> notes;
    coarse::Listener listener;
    listener.note = [&](const std::string& text) { notes.push_back(text); };
    listener.reached = [&](const coarse::LoadStep& step) { return !(step.ends_cycle && step.cycle == 11); };
    fine::FineModel fine(input), other_fine(input);
    coarse::CondensedFactory first(&fine, input), second(&other_fine, input);
    coarse::FatigueAnalysis begun(scene, first, listener);
    begun.run();
    const coarse::AnalysisState state = begun.state();
    const std::vector<std::string> said = notes_with(notes, "warning: tip 0: K_op / K_max goes to and fro");
    ASSERT_EQ(said.size(), 1U);
    EXPECT_NE(said[0].find("in cycle 8, 0.27 in cycle 10, 0.39 in cycle 11"), std::string::npos) << said[0];
    EXPECT_NE(said[0].find("fine.refine = 16"), std::string::npos) << said[0];
    coarse::FatigueAnalysis ended(scene, second, listener, &state);
    ended.run();
    EXPECT_TRUE(ended.finished());
    EXPECT_EQ(notes_with(notes, "goes to and fro").size(), 1U);
}

// A crack of 4.85 mm through elements of 0.1 mm.
TEST(SaidOfGrowth, SaysWhereFunctionsStandNoLonger) {
    Case input = specimen("sent", 40.0, {{0.0, 20.05}, {4.85, 20.05}});
    input.mesh.width = 20.0;
    input.mesh.size = 2.0;
    input.mesh.grading = {
        {.at = {{4.8, 20.02}, {5.2, 20.02}}, .size = 0.1, .outer_size = 0.2, .radius = 0.5, .growth = 0.3}};
    input.cracks[0].contact = ContactSection{};
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load = {.steps = 2, .blocks = {{.cycles = 5, .max = 60.0, .min = 0.0}}};
    input.growth = GrowthSection{.increment = 0.1, .direction = GrowthDirection::Straight};
    input.material.yield_stress = 1e6;
    EXPECT_EQ(notes_with(run_direct(input).notes, "warning: from here on no function stands at the tips").size(), 1U);
    input.fine.enrichment = Enrichment::None;
    EXPECT_TRUE(notes_with(run_direct(input).notes, "from here on").empty());
}

}  // namespace
}  // namespace stria::test
