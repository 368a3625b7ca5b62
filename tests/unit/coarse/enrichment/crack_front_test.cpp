// A crack without tip functions ends on an element edge near its tip.
#include "coarse/enrichment/crack_front.hpp"

#include <gtest/gtest.h>

#include "coarse/enrichment/crack_length.hpp"
#include "common/error.hpp"
#include "tests/support/cracked_mesh.hpp"

namespace stria::test {
namespace {

/// Of a 4 x 4 mesh of the unit square, whose elements have 0.25 mm.
EnrichedMesh ending_on_edges(const std::vector<Vec2>& points) { return cracked(square_mesh(4), points, 0); }

int jumping_nodes(const EnrichedMesh& mesh) { return static_cast<int>(mesh.terms.nodes().size()); }

TEST(CrackFront, LiesOnTheNearestEdge) {
    const struct {
        double tip, front;
    } cases[] = {{0.51, 0.5}, {0.625, 0.5}, {0.64, 0.75}, {0.74, 0.75}, {0.5, 0.5}, {0.75 + 1e-12, 0.75}};
    for (const auto& [tip, front] : cases) {
        const EnrichedMesh mesh = ending_on_edges({{0.0, 0.4}, {tip, 0.4}});
        EXPECT_NEAR(mesh.pieces.back().points.back().x(), front, 1e-14) << tip;
        EXPECT_NEAR(mesh.tips[0].s, front, 1e-14) << tip;
        EXPECT_NEAR(mesh.tips[0].position.x(), tip, 1e-11);  // the crack is as long as it is given, to rounding
        EXPECT_EQ(jumping_nodes(mesh), 2 * static_cast<int>(std::lround(4.0 * front))) << tip;
        EXPECT_GE(mesh.pieces.back().exit, 0.0) << tip;
        EXPECT_NEAR(coarse::length_in_body(mesh, 0), tip, 1e-11);
        EXPECT_EQ(mesh.mouths.at(0), 0.0);
    }
}

TEST(CrackFront, GoesStraightOnFromAnInclinedCrack) {
    const EnrichedMesh mesh = ending_on_edges({{0.0, 0.3}, {0.7, 0.44}});  // 1 : 5
    const CrackPiece& last = mesh.pieces.back();
    EXPECT_LT((last.points.back() - Vec2(0.75, 0.45)).norm(), 1e-14);
    EXPECT_NEAR(last.s.back(), std::hypot(0.75, 0.15), 1e-14);
    EXPECT_EQ(std::floor(last.exit), 1.0);  // the right edge, upwards
    EXPECT_NEAR(last.exit - 1.0, (0.45 - 0.25) / 0.25, 1e-13);
}

TEST(CrackFront, ReachesANodeThatItNearlyMeets) {
    const EnrichedMesh mesh = ending_on_edges({{0.0, 0.1}, {0.45, 0.46}});  // leaves its element at (0.4999, 0.5)
    EXPECT_EQ(mesh.pieces.back().points.back(), Vec2(0.5, 0.5));
    EXPECT_EQ(mesh.pieces.back().exit, 2.0);
}

TEST(CrackFront, AlongEdgesLiesOnTheNearestNode) {
    for (const auto& [tip, front] : {std::pair{0.55, 0.5}, {0.7, 0.75}}) {
        const EnrichedMesh mesh = ending_on_edges({{0.0, 0.5}, {tip, 0.5}});
        EXPECT_EQ(mesh.pieces.back().points.back(), Vec2(front, 0.5));
        EXPECT_EQ(jumping_nodes(mesh), static_cast<int>(std::lround(4.0 * front)));
    }
}

// An ulp off the edge the tip's piece is still along it: nothing would hold a jump on one side of a sliver.
TEST(CrackFront, AlongEdgesAnUlpDoesNotMatter) {
    for (const double y : {0.5, std::nextafter(0.5, 1.0), std::nextafter(0.5, 0.0)}) {
        const EnrichedMesh mesh = ending_on_edges({{0.0, 0.5}, {0.7, y}});
        EXPECT_EQ(jumping_nodes(mesh), 3) << y;
        EXPECT_GE(mesh.pieces.back().neighbour, 0) << y;
    }
}

// What is left of the crack beyond the edge is too short to tell where it heads.
TEST(CrackFront, StaysWhereTheTipLiesAHairBeyondTheEdge) {
    const EnrichedMesh mesh = ending_on_edges({{0.11, 0.4975}, {0.61 + 1e-9, 0.5 + 5e-12}});
    const CrackPiece& last = mesh.pieces.back();
    EXPECT_LT((last.points.back() - Vec2(0.61, 0.5)).norm(), 1e-8);
    EXPECT_NEAR(last.s.back() - last.s.front(), 0.11, 1e-5);
    EXPECT_LT(last.neighbour, 0);
}

// Down across a row of elements, out of one beside its node at (0.75, 0.5): nothing would open before the edge that it
// leaves there but a corner, for the other node of that edge is far from the crack.
TEST(CrackFront, PassesANodeRatherThanEndsBesideIt) {
    const Vec2 mouth(0.0, 0.652), past(0.745, 0.5);
    const Vec2 way = (past - mouth).normalized();
    for (const double beyond : {-0.1, -0.02, 0.003}) {  // the edge at 0.745, of the tip
        const EnrichedMesh mesh = ending_on_edges({mouth, past + beyond * way});
        const Vec2 front = mesh.pieces.back().points.back();
        EXPECT_NEAR(front.x(), 0.75, 1e-12) << beyond;
        EXPECT_NEAR((front - past).dot(way), (0.75 - 0.745) / way.x(), 1e-12);
        EXPECT_EQ(jumping_nodes(mesh), 8);  // all but the ends of the upright edge below that node
        EXPECT_NEAR(mesh.tips[0].s + mesh.tips[0].beyond, (past + beyond * way - mouth).norm(), 1e-12);
    }
}

// From a kink on an edge the last piece runs beside that edge, and beyond the tip it meets the edge's node: nothing
// would hold a jump between both.
TEST(CrackFront, StaysOnAnEdgeBesideWhichTheLastPieceRuns) {
    const Vec2 kink(0.5, 0.72);
    const EnrichedMesh mesh = ending_on_edges({{0.0, 0.4}, kink, {0.5 + 0.7e-3 * 0.25, 0.75 - 2e-3 * 0.25}});
    EXPECT_EQ(mesh.pieces.back().points.back(), kink);
    EXPECT_EQ(jumping_nodes(mesh), 6);
}

// No edge opens as a whole where the crack runs along part of it, or comes back to it.
TEST(CrackFront, StaysWhereTheCrackMeetsAnEdgeThatItDoesNotLeave) {
    const std::vector<Vec2> along{{0.0, 0.75}, {0.55, 0.5}, {0.7, 0.5}}, back{{0.0, 0.95}, {0.62, 0.46}, {0.72, 0.495}};
    for (const auto& crack : {along, back}) {
        const EnrichedMesh mesh = ending_on_edges(crack);
        EXPECT_NEAR(mesh.pieces.back().points.back().y(), 0.5, 1e-14);
        EXPECT_LT(mesh.pieces.back().points.back().x(), 0.57);
        EXPECT_LT(mesh.pieces.back().neighbour, 0);
    }
}

TEST(CrackFront, ArcLengthsBeginAtTheFirstPointOfAnInnerCrack) {
    const EnrichedMesh mesh = ending_on_edges({{0.26 + 0.1, 0.4}, {0.9, 0.4}});
    EXPECT_EQ(mesh.pieces.front().points.front(), Vec2(0.25, 0.4));
    EXPECT_NEAR(mesh.pieces.front().s.front(), -0.11, 1e-15);
    EXPECT_NEAR(mesh.pieces.back().s.back(), 1.0 - 0.36, 1e-14);
    EXPECT_NEAR(mesh.tips[0].s, -0.11, 1e-15);
    EXPECT_NEAR(mesh.tips[0].beyond, -0.11, 1e-15);
    EXPECT_NEAR(mesh.tips[1].beyond, -0.1, 1e-15);
    EXPECT_EQ(mesh.tips[0].position, Vec2(0.36, 0.4));
    EXPECT_NEAR(coarse::length_in_body(mesh, 0), 0.54, 1e-15);
    EXPECT_TRUE(std::isnan(mesh.mouths.at(0)));
}

// Its fronts lie on two edges of one element, or on one edge: no node is left that jumps.
TEST(CrackFront, ACrackOfLessThanTwoElementsIsRefused) {
    EXPECT_THROW(ending_on_edges({{0.1, 0.2}, {0.2, 0.2}}), CaseError);
    EXPECT_THROW(ending_on_edges({{0.2, 0.4}, {0.6, 0.4}}), CaseError);
    EXPECT_NO_THROW(ending_on_edges({{0.1, 0.4}, {0.65, 0.4}}));
}

TEST(CrackFront, TakesTheFunctionAwayWhereElementsAreSmallForTheCrack) {
    const coarse::TipEnrichment growing{.functions = 1, .none_below = 0.02};
    EXPECT_EQ(cracked(square_mesh(96), {{0.0, 0.4}, {0.53, 0.4}}, growing).tip_functions, 0);
    EXPECT_EQ(cracked(square_mesh(90), {{0.0, 0.4}, {0.53, 0.4}}, growing).tip_functions, 1);
}

}  // namespace
}  // namespace stria::test
