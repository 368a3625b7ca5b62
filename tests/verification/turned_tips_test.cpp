// A tip just behind a sharp turn: its K is not resolved there and far too low, and its growth does not go by it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "coarse/fracture/turned_tip.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

/// A plate with an edge crack of 45 degrees that turns at once, and as many straight ones from the other side.
Case plate_with_turning_crack(double at_tip, int straight_ones) {
    std::vector<Vec2> points{{0.0, 25.1}, {7.0, 32.1}};
    Case input = specimen("plate", 80.0, points);
    input.mesh.width = 40.0;
    input.mesh.size = 1.0;
    input.mesh.grading = {{.at = {points.back()}, .size = at_tip, .outer_size = {}, .radius = 2.0}};
    for (int k = 0; k < straight_ones; ++k) {
        input.cracks.emplace_back().points = {{40.0, 60.1}, {33.5, 60.1}};
        input.mesh.grading.push_back({.at = {{33.5, 60.1}}, .size = 0.5, .outer_size = {}, .radius = 2.0});
    }
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load.blocks = {{.cycles = 60, .max = 90.0, .min = 0.0}};
    input.load.steps = 2;
    input.growth = GrowthSection{.law = GrowthLaw::Paris, .increment = 0.25, .C = 1e-12, .m = 3.0};
    input.growth->until = 12.0;
    return input;
}

BoundarySection sheared(const std::string& edge, const Vec2& traction) {
    BoundarySection boundary;
    boundary.on = edge;
    boundary.traction = traction;
    return boundary;
}

double life(const RunHistory& run) {
    double N = 0.0;
    for (const Followed& increment : run.increments)
        if (!increment.cycles.empty()) N += increment.cycles.front().dN;
    return N;
}

auto times_said(const RunHistory& run, const std::string& words) {
    return std::ranges::count_if(run.notes, [&](const std::string& note) { return note.starts_with(words); });
}

// Two elements behind the turn K is 416 again; in the first of them it is below the threshold.
TEST(TurnedTips, AreNotArrestedByAKThatIsNotResolved) {
    Case input = plate_with_turning_crack(0.5, 0);
    input.growth->threshold = 380.0;
    const RunHistory run = run_direct(input);
    EXPECT_TRUE(run.life_is_over);
    EXPECT_NEAR(run.increments.back().tips.at(0).a, 12.0, 1e-3);
}

// J is told from rings that end two elements before a sharp bend (docs/verification/elastic.md, "J behind a bend"): in
// steps of 1.25 mm, two and a half elements, it was empty in the cycle behind the turn, and nothing said so.
TEST(TurnedTips, SayWhereTheirJIsNotTold) {
    Case input = plate_with_turning_crack(0.5, 0);
    const auto has_J_behind_turn = [](const RunHistory& run) {
        const auto behind = std::ranges::find_if(run.increments, [&](const Followed& increment) {
            return increment.tips.at(0).a > run.increments.front().tips.at(0).a && increment.step.reversal;
        });
        return std::isfinite(behind->tips.at(0).J);
    };
    const std::string words = "warning: tip 0 turns sharply and grows by 1.25 mm, 2.";
    input.growth->increment = 1.25;
    const RunHistory brief = run_direct(input);
    EXPECT_FALSE(has_J_behind_turn(brief));
    EXPECT_EQ(times_said(brief, words), 1);
    input.growth->increment = 2.1;
    const RunHistory longer = run_direct(input);
    EXPECT_TRUE(has_J_behind_turn(longer));
    EXPECT_EQ(times_said(longer, "warning: tip 0 turns sharply"), 0);
}

// K_I was asked alone: with a threshold above it, or in pure shear where it is nothing but rounding, a crack stood that
// K_II turns, and its life was endless. Behind its turn K is 1.2 times as large.
TEST(TurnedTips, AreDrivenByWhatDrivesThemBehindTheTurn) {
    Case input = plate_with_turning_crack(0.5, 0);
    input.growth->increment = 1.0;
    const RunHistory open = run_direct(input);
    const coarse::TipResult before = open.increments.front().tips.at(0);
    const double behind = coarse::K_just_turned(before, coarse::hoop_stress_angle(before.K_I, before.K_II));
    ASSERT_GT(behind, 1.1 * before.K_I);
    input.growth->threshold = 0.5 * (before.K_I + behind);
    const RunHistory driven = run_direct(input);
    EXPECT_TRUE(driven.life_is_over);
    EXPECT_NEAR(life(driven) / life(open), 1.0, 1e-12);
    input.growth->threshold = 1.01 * behind;
    EXPECT_EQ(run_direct(input).increments.back().tips.at(0).a, before.a);
}

/// A crack from the middle of an edge, at this height, grows by three millimetres under tension and shear.
RunHistory grown_from(double height, double increment, double shear) {
    Case input = specimen("plate", 40.0, {{0.0, height}, {7.4, height}});
    input.mesh.width = 20.0;
    input.mesh.size = 1.0;
    input.boundaries = {sheared("top", {shear, 1.0}), sheared("bottom", {-shear, -1.0}), sheared("right", {0.0, shear}),
                        sheared("left", {0.0, -shear})};
    const int advances = static_cast<int>(std::round(3.0 / increment));
    input.load.blocks = {{.cycles = advances, .max = 10.0, .min = 0.0}};
    input.load.steps = 2;
    input.growth = GrowthSection{.law = GrowthLaw::Prescribed, .increment = increment};
    RunHistory run = run_direct(input);
    EXPECT_NEAR(run.increments.back().tips.at(0).a, 7.4 + 3.0, 1e-6);
    return run;
}

// A crack on the line of nodes y = 20, its tip within an edge, could never turn, and its growth ended at once; then it
// turned at the end of the edge, up to an element too late. It leaves the edge where it is.
TEST(TurnedTips, LeaveTheElementEdgesAlongWhichTheyHaveCome) {
    for (const double increment : {0.5, 0.25}) {
        const RunHistory within = grown_from(20.3, increment, 0.1), along = grown_from(20.0, increment, 0.1);
        const double fall = within.increments.back().tips.at(0).y - 20.3;
        EXPECT_GT(std::abs(fall), 0.25);
        EXPECT_NEAR(along.increments.back().tips.at(0).y - 20.0, fall, 0.03 * std::abs(fall)) << increment;
        EXPECT_EQ(times_said(along, "a crack runs along an element edge"), 0);
    }
    const RunHistory within = grown_from(20.3, 0.5, 0.4), along = grown_from(20.0, 0.5, 0.4);
    EXPECT_NEAR(along.increments.back().tips.at(0).y + 0.3, within.increments.back().tips.at(0).y, 0.02);
    EXPECT_EQ(times_said(along, "warning: a crack runs along an element edge"), 0);
}

// Without functions the faces are open up to the end of the edge, where the crack turns within its step.
// What it grows by was the distance from tip to tip, 2 % less, and the life that much shorter.
TEST(TurnedTips, GrowByTheirWayAroundABend) {
    Case input = specimen("plate", 40.0, {{0.0, 20.0}, {7.75, 20.0}});
    input.mesh.width = 20.0;
    input.mesh.size = 1.0;
    input.fine.enrichment = Enrichment::None;
    input.boundaries = {sheared("top", {0.4, 1.0}), sheared("bottom", {-0.4, -1.0}), sheared("right", {0.0, 0.4}),
                        sheared("left", {0.0, -0.4})};
    input.load = {.steps = 2, .blocks = {{.cycles = 3, .max = 10.0, .min = 0.0}}};
    input.growth = GrowthSection{.law = GrowthLaw::Prescribed, .increment = 0.5};
    std::vector<double> ways;
    double straight = 1.0;
    Vec2 last(7.75, 20.0);
    for (const Followed& increment : run_direct(input).increments) {
        if (increment.cycles.empty()) continue;
        const Vec2 now(increment.tips[0].x, increment.tips[0].y);
        if (now != last) straight = std::min(straight, (now - std::exchange(last, now)).norm());
        ways.push_back(increment.cycles[0].da);
    }
    EXPECT_LT(straight, 0.495) << "it turns within a step";
    ASSERT_EQ(ways.size(), 3U);
    EXPECT_EQ(ways[0], 0.0);
    for (const double way : {ways[1], ways[2]}) EXPECT_NEAR(way, 0.5, 1e-3) << "a tip beside a node is put onto it";
}

// The toughness was asked of K_I alone, 416 here, where the crack would break by 490 as it turns.
TEST(TurnedTips, BreakByTheKBehindTheTurn) {
    Case input = plate_with_turning_crack(0.5, 0);
    const RunHistory whole = run_direct(input);
    const coarse::TipResult before = whole.increments.front().tips.at(0);
    const double behind = coarse::K_just_turned(before, coarse::hoop_stress_angle(before.K_I, before.K_II));
    const auto grown_with = [&](double toughness) {
        input.growth->toughness = toughness;
        return run_direct(input).increments.back().tips.at(0).a - before.a;
    };
    EXPECT_EQ(grown_with(0.5 * (before.K_I + behind)), 0.0);
    EXPECT_GT(grown_with(1.05 * behind), 0.5) << "two elements from the turn, where K_I is resolved";
    input.growth->direction = GrowthDirection::Straight;
    EXPECT_GT(grown_with(0.5 * (before.K_I + behind)), 0.0);
}

Case sheared_plate() {
    Case input = plate_with_turning_crack(0.5, 0);
    input.mesh.grading.clear();
    input.cracks[0].points = {{15.0, 40.1}, {25.0, 40.1}};
    input.boundaries = {sheared("top", {1.0, 0.0}), sheared("bottom", {-1.0, 0.0}), sheared("left", {0.0, -1.0}),
                        sheared("right", {0.0, 1.0})};
    input.load.blocks = {{.cycles = 9, .max = 90.0, .min = 0.0}};
    input.growth->increment = 1.5;
    input.growth->until = 8.0;
    return input;
}

double life_of(const Case& input) {
    const RunHistory run = run_direct(input);
    EXPECT_TRUE(run.life_is_over);
    return life(run);
}

// Under loads that vary a crack in pure shear was arrested. Half as large a load drives a tip an eighth as fast.
TEST(TurnedTips, LeaveACrackUnderShearThatVaries) {
    Case input = sheared_plate();
    input.growth->until = 7.5;  // by two growths: a short third one turns sharply in elements as large as these
    const double alike = life_of(input);
    input.load.blocks = {{.cycles = 1, .max = 45.0, .min = 0.0}, {.cycles = 1, .max = 90.0, .min = 0.0}};
    input.load.repeat = 9;
    input.growth->every = 2;
    EXPECT_NEAR(life_of(input) / alike, 2.0 / (1.0 + 1.0 / 8.0), 5e-3) << "the slower tip goes by no trend";
}

// So was one whose faces may rub, or without contact under dK_eff. Pressed faces keep shear from a tip, and then nobody
// knows what drives it once it has turned.
TEST(TurnedTips, LeaveACrackThatRubsOrHasNoContact) {
    Case input = sheared_plate();
    const double free = life_of(input);
    input.growth->driving = GrowthDriving::EffectiveRange;
    EXPECT_NEAR(life_of(input) / free, 1.0, 5e-3) << "likewise";
    input.growth->driving = GrowthDriving::Range;
    input.cracks[0].contact.emplace().friction = 0.0;
    const double smooth = life_of(input);
    input.cracks[0].contact->friction = 0.3;
    EXPECT_NEAR(life_of(input) / smooth, 1.0, 0.02);
    input.boundaries[0].traction->y() = -1.0;
    input.boundaries[1].traction->y() = 1.0;
    EXPECT_FALSE(run_direct(input).life_is_over);
}

// One crack, sheared to either side and to and fro: rounding decided about its K_I, and by that whether it grew at all.
TEST(TurnedTips, LeaveACrackUnderPureShear) {
    Case input = sheared_plate();
    std::vector<double> lives;
    for (const auto& [max, min] : {std::pair{90.0, 0.0}, {0.0, -90.0}, {90.0, -90.0}}) {
        input.load.blocks = {{.cycles = 9, .max = max, .min = min}};
        const RunHistory run = run_direct(input);
        EXPECT_TRUE(run.life_is_over);
        lives.push_back(life(run));
    }
    EXPECT_NEAR(lives[1] / lives[0], 1.0, 1e-6);
    EXPECT_NEAR(lives[2] / lives[0], 1.0, 1e-6);
}

// In shear K_I is what the mesh makes of it, here 3e-4 of K_II and below zero at one of the tips. That one grew, and
// the other by 1e-11 mm around a bend, on which their growth ended.
TEST(TurnedTips, OfACrackUnderPureShearGrowAlike) {
    const Vec2 left(14.13, 20.2), right(26.05, 20.2);
    Case input = sheared_plate();
    input.mesh = {.specimen = "plate", .width = 40.0, .height = 40.0, .size = 2.0, .grading = {}};
    for (const Vec2& end : {left, right})
        input.mesh.grading.push_back({.at = {end}, .size = 0.25, .outer_size = 0.5, .radius = 3.0});
    input.cracks[0].points = {left, right};
    input.load.blocks = {{.cycles = 4, .max = 20.0, .min = 0.0}};
    input.growth->increment = 0.5;
    const std::vector<coarse::TipResult> tips = run_direct(input).increments.back().tips;
    const Vec2 by_left = Vec2(tips[0].x, tips[0].y) - left, by_right = Vec2(tips[1].x, tips[1].y) - right;
    EXPECT_GT(by_left.norm(), 1.9);
    EXPECT_LT((by_left + by_right).norm(), 0.01) << "half a turn apart";
}

// Beside a crack that then was the faster one a tip grew by a tenth of an element at a time and never left its turn:
// its own life was left out, and that of the other one was 57 % too long.
TEST(TurnedTips, LeaveTheirTurnBesideACrackThatIsFasterThere) {
    const RunHistory coarse = run_direct(plate_with_turning_crack(0.5, 1)),
                     fine = run_direct(plate_with_turning_crack(0.1, 1));
    EXPECT_NEAR(fine.increments.back().tips.at(0).a, 12.0, 1e-3);
    EXPECT_NEAR(coarse.increments.back().tips.at(0).a, 12.0, 1e-3);
    EXPECT_NEAR(life(coarse) / life(fine), 1.0, 0.10);
}

}  // namespace
}  // namespace stria::test
