#include "coarse/growth/crack_advance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/crack/notch.hpp"
#include "common/crack/straight_way.hpp"

namespace stria::coarse {
namespace {

TEST(CrackAdvance, MovesTheEndOfAStraightCrackAndBendsAtACorner) {
    CrackSection crack{.points = {{0.0, 1.0}, {2.0, 1.0}}, .contact = {}};
    const Tip tip{.crack = 0, .position = {2.0, 1.0}, .direction = {1.0, 0.0}, .s = 2.0, .upper = 1};
    advance(crack, tip, {1.0, 0.0}, 0.25);
    ASSERT_EQ(crack.points.size(), 2U);
    EXPECT_EQ(crack.points[1], Vec2(2.25, 1.0));
    const Tip grown{.crack = 0, .position = {2.25, 1.0}, .direction = {1.0, 0.0}, .s = 2.25, .upper = 1};
    advance(crack, grown, {0.6, 0.8}, 0.5);
    ASSERT_EQ(crack.points.size(), 3U);
    EXPECT_LT((crack.points[2] - Vec2(2.55, 1.4)).norm(), 1e-15);
}

// Its ends lie on one rounded direction, whatever the rounding of each: what it has cut stays the same to the bit.
TEST(CrackAdvance, GoesStraightOnAlongOneLine) {
    CrackSection crack{.points = {{0.0, 100.03}, {2.0, 100.03}}, .contact = {}};
    Tip tip{.crack = 0, .position = {2.0, 100.03}, .direction = {1.0, 0.0}, .s = 2.0, .upper = 1};
    advance(crack, tip, Vec2(0.97, 0.21).normalized(), 1.0);
    const Vec2 first = rounded_direction(crack.points[2] - crack.points[1]);
    for (int step = 0; step < 100; ++step) {
        EXPECT_EQ(on_rounded_way(crack.points[1], crack.points[2]), crack.points[2]) << step;
        EXPECT_EQ(rounded_direction(crack.points[2] - crack.points[1]), first) << step;
        tip.position = crack.points[2];
        tip.direction = (crack.points[2] - crack.points[1]).normalized();
        advance(crack, tip, tip.direction, 0.07);
        ASSERT_EQ(crack.points.size(), 3U);
    }
}

TEST(CrackAdvance, MovesTheFirstPointOfACrackThatStartsAtATip) {
    CrackSection crack{.points = {{1.0, 1.0}, {2.0, 1.0}}, .contact = {}};
    advance(crack, {.crack = 0, .position = {1.0, 1.0}, .direction = {-1.0, 0.0}, .s = 0.0, .upper = -1}, {-1.0, 0.0},
            0.25);
    EXPECT_EQ(crack.points.front(), Vec2(0.75, 1.0));
    EXPECT_EQ(crack.grown_at_start, 0.25);
}

// A notch is an arc length from where the first point was.
TEST(CrackAdvance, KnowsHowFarTheFirstPointHasMoved) {
    CrackSection crack{.points = {{1.0, 1.0}, {2.0, 1.0}}, .contact = {}, .notch = 0.5};
    const auto tip_at = [&](std::size_t point, int upper) {
        const Vec2 before = crack.points[upper > 0 ? point - 1 : point + 1];
        return Tip{.crack = 0,
                   .position = crack.points[point],
                   .direction = (crack.points[point] - before).normalized(),
                   .s = 0.0,
                   .upper = upper};
    };
    advance(crack, tip_at(1, 1), {1.0, 0.0}, 0.4);
    EXPECT_EQ(crack.grown_at_start, 0.0) << "the other end";
    advance(crack, tip_at(0, -1), {-1.0, 0.0}, 0.25);
    advance(crack, tip_at(0, -1), {-0.8, 0.6}, 0.5);
    advance(crack, tip_at(0, -1), {-0.8, 0.6}, 0.125);
    EXPECT_EQ(crack.points.size(), 3U);
    EXPECT_NEAR(crack.grown_at_start, 0.875, 1e-15);
    const Notch notch = notch_of(crack, crack.grown_at_start);
    EXPECT_TRUE(notch.holds(0.9) && notch.holds(1.37) && !notch.holds(0.87) && !notch.holds(1.38));
}

// The mesh holds a tip on a node, 0.9 thousandths of an edge from where the crack ends.
TEST(CrackAdvance, StepsShorterThanWhatANodePullsATipByAddUp) {
    for (const int upper : {1, -1}) {
        CrackSection crack{.points = {{0.0, 1.0}, {2.0, 1.0}}, .contact = {}};
        if (upper < 0) std::swap(crack.points[0], crack.points[1]);
        const Tip on_node{.crack = 0, .position = {2.0, 1.0}, .direction = {1.0, 0.0}, .s = 0.0, .upper = upper};
        const auto end = [&] { return upper > 0 ? crack.points.back() : crack.points.front(); };
        for (int step = 1; step <= 3; ++step) {
            advance(crack, on_node, {1.0, 0.0}, 3e-4);
            EXPECT_NEAR(end().x(), 2.0 + step * 3e-4, 1e-15);
        }
        const Vec2 along(0.8, 0.6);
        for (int step = 1; step <= 2; ++step) advance(crack, on_node, along, 3e-4);
        ASSERT_EQ(crack.points.size(), 3U) << "one corner, on the node";
        EXPECT_EQ(crack.points[1], Vec2(2.0, 1.0));
        EXPECT_LT((end() - Vec2(2.0, 1.0) - (0.8 * 9e-4 + 6e-4) * along).norm(), 1e-15);
    }
}

// Elements of 1 mm; the tip lies 0.3 mm along the crack beyond the edge y = 1 of the row that it has come from.
TEST(CrackAdvance, BendsBeforeTheEdgeThatItHasComeOver) {
    EnrichedMesh mesh;
    mesh.nodes = {{2.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {2.0, 1.0}, {3.0, 2.0}, {2.0, 2.0}};
    mesh.elements = {{0, 1, 2, 3}, {3, 2, 4, 5}};
    const double s = 2.0 * std::numbers::sqrt2;
    const Vec2 along = Vec2(1.0, 1.0).normalized(), tip = Vec2(2.2, 1.0) + 0.3 * along, end = tip + Vec2(1.0, -0.5);
    mesh.pieces = {
        {.crack = 0, .element = 0, .neighbour = -1, .points = {}, .s = {0.5, s}, .entry = 3.2, .exit = 2.8},
        {.crack = 0, .element = 1, .neighbour = -1, .points = {}, .s = {s, s + 1.0}, .entry = 0.2, .exit = 1.8}};
    for (const double beyond : {0.3, -0.7}) {  // faces end before the tip, or ahead of it
        const bool opened = beyond < 0.0;
        Tip of_crack{.crack = 0, .position = tip, .direction = along, .s = s + (opened ? 1.0 : 0.0), .upper = 1};
        of_crack.beyond = beyond;
        CrackSection crack{.points = {tip - (s + 0.3) * along, tip, end}, .contact = {}};
        ASSERT_TRUE(bend_before_edge(crack, mesh, of_crack));
        EXPECT_LT((crack.points[1] - (tip - 0.32 * along)).norm(), 1e-12) << beyond;
        EXPECT_EQ(crack.points[2], end);
        EXPECT_EQ(crack.grown_at_start, 0.0);
        EXPECT_FALSE(bend_before_edge(crack, mesh, of_crack)) << "it has gone straight on";
        const Vec2 bend = tip - 0.3 * along + Vec2(0.0, 0.1);  // beyond the edge
        CrackSection bent{.points = {bend - Vec2(0.0, 2.0), bend, tip, end}, .contact = {}};
        ASSERT_TRUE(bend_before_edge(bent, mesh, of_crack));
        ASSERT_EQ(bent.points.size(), 3U);
        EXPECT_EQ(bent.points[1].x(), bend.x());
        EXPECT_LT(bent.points[1].y(), bend.y() - 0.019);
        CrackSection of_short{.points = {tip - 0.33 * along, tip, end}, .contact = {}};
        EXPECT_FALSE(bend_before_edge(of_short, mesh, of_crack)) << "it has begun there";
    }
}

// Elements of 1 mm on either side of the crack, whose tip lies 0.3 mm before the end of an edge.
TEST(CrackAdvance, TurnsAtTheEndOfTheEdgeThatItRunsAlong) {
    EnrichedMesh mesh;
    mesh.nodes = {{2.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {2.0, 1.0}, {3.0, 2.0}, {2.0, 2.0}, {4.0, 1.0}};
    mesh.elements = {{0, 1, 2, 3}, {3, 2, 4, 5}};
    mesh.pieces = {
        {.crack = 0, .element = 0, .neighbour = 1, .points = {}, .s = {2.0, 2.7}, .entry = 3.0, .exit = -1.0}};
    const Vec2 at_tip(2.7, 1.0), up(0.6, 0.8);
    for (const int upper : {1, -1}) {
        const Tip tip{.crack = 0, .position = at_tip, .direction = {1.0, 0.0}, .s = 2.7, .upper = upper};
        const auto turned = [&](double by) {
            CrackSection crack{.points = {{0.0, 1.0}, at_tip, at_tip + by * up}, .contact = {}};
            if (upper < 0) std::ranges::reverse(crack.points);
            EXPECT_TRUE(turn_at_end_of_edge(crack, mesh, tip));
            if (upper < 0) std::ranges::reverse(crack.points);
            return crack.points;
        };
        const std::vector<Vec2> far = turned(0.5), near = turned(0.2);
        ASSERT_EQ(far.size(), 3U);
        EXPECT_EQ(far[1], Vec2(3.0, 1.0));
        EXPECT_LT((far[2] - (far[1] + 0.2 * up)).norm(), 1e-12);
        ASSERT_EQ(near.size(), 2U);
        EXPECT_LT((near[1] - Vec2(2.9, 1.0)).norm(), 1e-12);
        CrackSection straight{.points = {{0.0, 1.0}, {2.9, 1.0}}, .contact = {}};
        if (upper < 0) std::ranges::reverse(straight.points);
        EXPECT_FALSE(turn_at_end_of_edge(straight, mesh, tip));
    }
    Tip tip{.crack = 0, .position = at_tip, .direction = {1.0, 0.0}, .s = 2.7, .upper = 1};
    for (const double beyond : {-0.3, 0.7}) {  // faces are open up to the end of the edge, or only to its beginning
        tip.beyond = beyond;
        mesh.tips = {tip};
        std::vector<CrackSection> cracks{{.points = {{0.0, 1.0}, at_tip, at_tip + 0.5 * up}, .contact = {}}};
        turn_where_faces_end(cracks, mesh);
        EXPECT_EQ(cracks[0].points[1], beyond < 0.0 ? Vec2(3.0, 1.0) : at_tip);
    }
    mesh.pieces[0].neighbour = -1;  // the crack cuts the element
    const Tip within{.crack = 0, .position = at_tip, .direction = {1.0, 0.0}, .s = 2.7, .upper = 1};
    CrackSection crack{.points = {{0.0, 1.0}, at_tip, at_tip + 0.5 * up}, .contact = {}};
    EXPECT_FALSE(turn_at_end_of_edge(crack, mesh, within));
}

TEST(CrackAdvance, KnowsHowFarATipIsBehindASharpTurn) {
    const CrackSection crack{.points = {{0.0, 0.0}, {3.0, 0.0}, {3.4, 0.3}, {4.4, 1.0}}, .contact = {}};
    const Tip last{.crack = 0, .position = {4.4, 1.0}, .direction = {0.8, 0.56}, .s = 0.0, .upper = 1};
    EXPECT_NEAR(behind_sharp_turn(crack, last), 0.5 + std::hypot(1.0, 0.7), 1e-14);  // 37 and then 2 degrees
    const Tip first{.crack = 0, .position = {0.0, 0.0}, .direction = {-1.0, 0.0}, .s = 0.0, .upper = -1};
    EXPECT_NEAR(behind_sharp_turn(crack, first), 3.0, 1e-14);
    const CrackSection straight{.points = {{0.0, 0.0}, {3.0, 0.0}}, .contact = {}};
    EXPECT_TRUE(std::isinf(behind_sharp_turn(straight, first)));
}

/// The farthest that a crack gets from the circle of radius 50 mm whose tangent it turns to at the end of each step.
double farthest_from_a_circle(double increment, double element) {
    CrackSection crack{.points = {{-5.0, 0.0}, {0.0, 0.0}}, .contact = {}};
    const double radius = 50.0;
    const Vec2 centre(0.0, radius);
    double farthest = 0.0;
    for (double s = 0.0; s < 20.0; s += increment) {
        const Vec2 end = crack.points.back(), along = (end - crack.points[crack.points.size() - 2]).normalized();
        const Vec2 tangent = Vec2(centre.y() - end.y(), end.x() - centre.x()).normalized();
        const double angle = std::asin(cross(along, tangent));
        const double K_II = -std::sin(angle) / (3.0 * std::cos(angle) - 1.0);  // of the largest hoop stress there
        const Tip tip{.crack = 0, .position = end, .direction = along, .s = 0.0, .upper = 1};
        crack = longer_cracks({crack}, GrowthDirection::HoopStress, {{tip, 1.0, K_II, increment, element}})[0];
        farthest = std::max(farthest, std::abs((crack.points.back() - centre).norm() - radius));
    }
    return farthest;
}

// Nothing is lost below some angle.
TEST(CrackAdvance, TheWayConvergesWithItsSteps) {
    const double whole = farthest_from_a_circle(1.0, 1.0), half = farthest_from_a_circle(0.5, 1.0);
    EXPECT_GT(whole, 0.1);
    EXPECT_NEAR(half, 0.5 * whole, 0.05 * whole);
    EXPECT_NEAR(farthest_from_a_circle(0.25, 1.0), 0.25 * whole, 0.05 * whole);
    EXPECT_LT(farthest_from_a_circle(0.01, 1.0), 0.15 * whole);  // corners are 0.1 elements apart: sqrt(2e-4 radius)
    EXPECT_LT(farthest_from_a_circle(0.01, 0.05), 0.04 * whole);
}

TEST(CrackAdvance, HasNoCornerWithinTheTolerance) {
    EXPECT_EQ(turn(1.9e-4, 0.8, 0.2, 1.0), 0.0);
    EXPECT_EQ(turn(2.1e-4, 0.8, 0.2, 1.0), 2.1e-4);
    EXPECT_EQ(turn(-2.1e-4, 0.8, 0.2, 1.0), -2.1e-4);
    EXPECT_EQ(turn(2.1e-4, 0.6, 0.2, 1.0), 0.0);   // waits until the stretch is as long
    EXPECT_EQ(turn(1.9e-4, 20.0, 0.0, 1.0), 0.0);  // not for ever: K_II has an error
    EXPECT_EQ(turn(1.9e-4, 20.0, 0.2, 1.0), 1.9e-4);
}

TEST(CrackAdvance, WhereFacesTouchTipsGoWhereTheSolutionReachedSays) {
    const std::vector<TipResult> nominal{{.K_I = 1.0, .K_II = 2.0}, {.K_I = 1.0, .K_II = 2.0}};
    const std::vector<double> largest{2.0, 2.0};
    std::vector<TipResult> reached{{.K_I = 5.0, .K_II = 6.0}, {.K_I = -1e-9, .K_II = 0.5}};
    EXPECT_EQ(directing(nominal, reached, largest)[1].K_II, 2.0);  // open from end to end
    reached[1].contact_length = 0.1;                               // of the other crack, too
    std::vector<TipResult> chosen = directing(nominal, reached, largest);
    EXPECT_EQ(chosen[0].K_I, 5.0);
    EXPECT_EQ(chosen[0].K_II, 6.0);
    EXPECT_EQ(chosen[1].K_I, -1e-9);
    EXPECT_EQ(chosen[1].K_II, 0.5);
    std::vector<TipResult> flowed = reached;
    flowed[1].rings_flow = true;
    chosen = directing(nominal, flowed, largest);
    EXPECT_EQ(chosen[0].K_II, 6.0);
    EXPECT_EQ(chosen[1].K_II, 2.0);
    reached[1].K_II = 0.009;  // next to nothing
    EXPECT_EQ(directing(nominal, reached, largest)[1].K_II, 2.0);
}

// A slow tip beside a fast one that K_II would turn: 1e-11 mm behind its bend nobody could tell its K.
TEST(CrackAdvance, WhoTurnsByNextToNoAdvanceStays) {
    std::vector<CrackSection> cracks(1);
    cracks[0].points = {{0.0, 0.0}, {4.0, 0.0}};
    const Tip tip{.crack = 0, .position = {4.0, 0.0}, .direction = {1.0, 0.0}, .s = 4.0, .upper = 1};
    const auto grown = [&](double K_II, double by) {
        return longer_cracks(cracks, GrowthDirection::HoopStress, {{tip, 1.0, K_II, by, 0.5}})[0];
    };
    EXPECT_EQ(grown(10.0, 1e-11).points.size(), 2U);
    EXPECT_EQ(grown(10.0, 1e-11).points.back(), Vec2(4.0, 0.0));
    EXPECT_EQ(grown(10.0, 1e-4).points.size(), 3U);
    EXPECT_GT(grown(0.0, 1e-11).points.back().x(), 4.0) << "straight steps add up";
}

TEST(CrackAdvance, AWakeThatTouchesTurnsNoTip) {
    const std::vector<TipResult> nominal{{.K_I = 1.0, .K_II = 0.5}};
    const std::vector<TipResult> reached{
        {.K_I = 1.5, .K_II = 0.25, .K_I_of_wake = 0.5, .K_II_of_wake = -0.25, .contact_length = 0.1}};
    const std::vector<TipResult> chosen = directing(nominal, reached, {1.0});
    EXPECT_EQ(chosen[0].K_I, 1.0);
    EXPECT_EQ(chosen[0].K_II, 0.5);
}

}  // namespace
}  // namespace stria::coarse
