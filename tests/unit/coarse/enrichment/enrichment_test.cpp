// Eq. (1): which nodes get which terms.
#include "coarse/enrichment/enrichment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ranges>
#include <set>

#include "common/enrichment/tip_functions.hpp"
#include "common/error.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/refusal.hpp"

namespace stria::test {
namespace {

using Nodes = std::set<int>;

/// Node of a 4 x 4 mesh of the unit square.
int node(int column, int row) { return 5 * row + column; }

Nodes heaviside_nodes(const EnrichedMesh& mesh, double side) {
    Nodes nodes;
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n)
        if (heaviside_side(mesh, n) == side) nodes.insert(n);
    return nodes;
}

Nodes tip_nodes(const EnrichedMesh& mesh) {
    Nodes nodes;
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n)
        if (has_tip_terms(mesh, n)) nodes.insert(n);
    return nodes;
}

TEST(Enrichment, TipInsideAnElement) {
    const EnrichedMesh mesh = cracked(square_mesh(4), {{0.0, 0.4}, {0.6, 0.4}});
    EXPECT_EQ(heaviside_nodes(mesh, 1.0), (Nodes{node(0, 2), node(1, 2)}));
    EXPECT_EQ(heaviside_nodes(mesh, -1.0), (Nodes{node(0, 1), node(1, 1)}));
    EXPECT_EQ(tip_nodes(mesh), (Nodes{node(2, 1), node(3, 1), node(2, 2), node(3, 2)}));
    for (const int n : tip_nodes(mesh)) EXPECT_EQ(mesh.terms[at(n)].size(), 6U);
}

TEST(Enrichment, MouthOutsideTheBodyChangesNothing) {
    const EnrichedMesh inside = cracked(square_mesh(4), {{0.0, 0.4}, {0.6, 0.4}});
    const EnrichedMesh outside = cracked(square_mesh(4), {{-1.0, 0.4}, {0.6, 0.4}});
    EXPECT_EQ(heaviside_nodes(inside, 1.0), heaviside_nodes(outside, 1.0));
    EXPECT_EQ(tip_nodes(inside), tip_nodes(outside));
}

// By three quarters of the way to the middle the disks met up to eleven elements apart. What is far away changes
// nothing.
TEST(Enrichment, DisksOfTwoTipsKeepClearOfEachOther) {
    const BodyMesh mesh(square_mesh(40));
    const auto cracked_by = [&](const std::vector<std::vector<Vec2>>& ways) {
        std::vector<CrackSection> cracks;
        for (const std::vector<Vec2>& points : ways) cracks.push_back({.points = points, .contact = {}});
        return coarse::enrich(mesh, cracks, {4, 0.5, coarse::TipSupport::Nodal});
    };
    EXPECT_NO_THROW(cracked_by({{{0.0, 0.51}, {0.4, 0.51}}, {{1.0, 0.51}, {0.51, 0.51}}}));
    const std::vector<Vec2> brief{{0.0, 0.51}, {0.1, 0.51}}, far{{1.0, 0.51}, {0.91, 0.51}};
    const Nodes alone = tip_nodes(cracked_by({brief})), beside = tip_nodes(cracked_by({brief, far}));
    EXPECT_GT(alone.size(), 4U);
    for (const int n : alone) EXPECT_TRUE(beside.contains(n)) << n;
}

TEST(Enrichment, SingleTipFunction) {
    const EnrichedMesh mesh = cracked(square_mesh(4), {{0.0, 0.4}, {0.6, 0.4}}, 1);
    for (const int n : tip_nodes(mesh)) EXPECT_EQ(mesh.terms[at(n)].size(), 1U);
    EXPECT_EQ(mesh.unknowns, 2 * (25 + 4 + 4));
}

TEST(Enrichment, WithoutTipFunctionsTheCrackEndsOnTheNearestEdge) {
    const EnrichedMesh mesh = cracked(square_mesh(4), {{0.0, 0.4}, {0.6, 0.4}}, 0);
    EXPECT_EQ(heaviside_nodes(mesh, 1.0), (Nodes{node(0, 2), node(1, 2)}));
    EXPECT_TRUE(tip_nodes(mesh).empty());
}

TEST(Enrichment, TipOnAnEdgeBelongsToTheElementBehind) {
    const EnrichedMesh mesh = cracked(square_mesh(4), {{0.0, 0.4}, {0.5, 0.4}});
    EXPECT_EQ(tip_nodes(mesh), (Nodes{node(1, 1), node(2, 1), node(1, 2), node(2, 2)}));
    EXPECT_EQ(heaviside_nodes(mesh, 1.0), (Nodes{node(0, 2)}));
}

TEST(Enrichment, TipOnANodeOfACrackAlongEdges) {
    const EnrichedMesh mesh = cracked(square_mesh(4), {{0.0, 0.5}, {0.5, 0.5}});
    EXPECT_EQ(heaviside_nodes(mesh, 1.0), (Nodes{node(0, 2)}));
    EXPECT_TRUE(heaviside_nodes(mesh, -1.0).empty());
    EXPECT_EQ(tip_nodes(mesh), (Nodes{node(1, 1), node(2, 1), node(1, 2), node(2, 2), node(1, 3), node(2, 3)}));
}

TEST(Enrichment, AlongEdgesOnlyTheNodesOnTheCrackJump) {
    const EnrichedMesh mesh = cracked(square_mesh(4), {{0.0, 0.5}, {1.0, 0.5}});
    EXPECT_EQ(heaviside_nodes(mesh, 1.0), (Nodes{node(0, 2), node(1, 2), node(2, 2), node(3, 2), node(4, 2)}));
    EXPECT_TRUE(heaviside_nodes(mesh, -1.0).empty());
    for (int e = 4; e < 12; ++e) EXPECT_EQ(mesh.element_side[at(e)], e < 8 ? -1 : 1);
}

TEST(Enrichment, ThroughNodesTheyCountAsPlus) {
    const EnrichedMesh mesh = cracked(square_mesh(4), {{0.0, 0.0}, {1.0, 1.0}});
    EXPECT_EQ(heaviside_nodes(mesh, -1.0), (Nodes{node(1, 0), node(2, 1), node(3, 2), node(4, 3)}));
    for (int k = 0; k < 5; ++k) EXPECT_EQ(heaviside_side(mesh, node(k, k)), 1.0);
    EXPECT_EQ(mesh.element_side[1], -1);  // below the crack, touches it at one node
    EXPECT_EQ(mesh.element_side[4], 1);
}

// Slanted so much that the element beyond the tip's next corner reaches back across the line through the tip: on either
// branch of theta elements beside a tip are in one piece.
TEST(Enrichment, SidesBesideATipTearNoElement) {
    Mesh mesh = square_mesh(4, 4.0);
    for (Vec2& x : mesh.nodes) x.x() -= 0.8 * x.y();
    const Vec2 tip(1.16, 1.0);
    const EnrichedMesh enriched = cracked(mesh, {tip - Vec2(2.65, 1.41), tip}, 1);
    for (int e = 0; e < std::ssize(mesh.elements); ++e) {
        const auto corners = corners_of_element(enriched, e);
        const auto angle = [&](const Vec2& x) {
            return tip_polar(enriched.tips[0], x, enriched.element_side[at(e)]).theta;
        };
        const auto [least, most] = std::ranges::minmax(corners | std::views::transform(angle));
        const bool beside =
            std::ranges::any_of(mesh.elements[at(e)], [&](int n) { return has_tip_terms(enriched, n); });
        if (!beside || piece_in(enriched, e) != nullptr) continue;
        EXPECT_LT(most - least, 3.15) << e;
    }
}

// The crack comes to an edge through an element and ends on it: seen along the edge that element's far corner is right
// of the crack, and yet above it.
TEST(Enrichment, SidesBesideAnEdgeAreThoseOfTheElementThatTheCrackCameThrough) {
    const EnrichedMesh mesh = cracked(square_mesh(4), {{0.0, 0.4}, {0.5, 0.4}, {0.5, 0.36}}, 1);
    const int above = node(1, 2), below = node(1, 1);
    for (const auto& [n, side] : {std::pair(above, 1), std::pair(below, -1)}) {
        ASSERT_TRUE(has_tip_terms(mesh, n));
        EXPECT_EQ(mesh.terms[at(n)].back().shift, tip_functions(mesh.tips[0], mesh.nodes[at(n)], side, 0.5).value[0]);
    }
}

TEST(Enrichment, ACrackInsideHasTwoTipsThatFaceOutwards) {
    const EnrichedMesh mesh = cracked(square_mesh(8), {{0.2, 0.4}, {0.8, 0.4}});
    ASSERT_EQ(mesh.tips.size(), 2U);
    EXPECT_EQ(mesh.tips[0].direction, Vec2(-1.0, 0.0));
    EXPECT_EQ(mesh.tips[1].direction, Vec2(1.0, 0.0));
    EXPECT_EQ(mesh.tips[0].upper, -1);
    EXPECT_EQ(mesh.tips[1].upper, 1);
}

TEST(Enrichment, ATipJustBeyondASnappedCrossingKeepsItsDirection) {
    const EnrichedMesh mesh = cracked(square_mesh(4), {{0.0, 0.2505}, {0.2504, 0.2502}});
    EXPECT_EQ(mesh.pieces.back().points.front(), Vec2(0.25, 0.25));  // a last piece at 27 degrees
    EXPECT_LT((mesh.tips[0].direction - Vec2(0.2504, -0.0003).normalized()).norm(), 1e-15);
}

// Behind such a tip theta would be more than 3/2 pi. Without functions nothing asks for it.
TEST(Enrichment, RefusesATipThatTurnsBackInItsElement) {
    const std::vector<Vec2> hook{{0.0, 0.4}, {0.6, 0.4}, {0.63, 0.37}, {0.61, 0.34}};
    EXPECT_THROW(cracked(square_mesh(4), hook, 1), CaseError);
    EXPECT_NO_THROW(cracked(square_mesh(4), hook, 0));
}

// Its functions act one element farther, and there the crack would lie ahead of it.
TEST(Enrichment, RefusesATipThatTurnsBackBesideItsElement) {
    const std::vector<Vec2> hook{{0.0, 0.4}, {0.49, 0.4}, {0.51, 0.41}, {0.506, 0.42}};
    EXPECT_THROW(cracked(square_mesh(4), hook, 1), CaseError);
    EXPECT_NO_THROW(cracked(square_mesh(4), hook, 0));
    EXPECT_NO_THROW(cracked(square_mesh(4), {{0.0, 0.4}, {0.49, 0.4}, {0.51, 0.41}, {0.51, 0.42}}, 1));
}

TEST(Enrichment, RefusesCracksAndTipsTooCloseForTheMesh) {
    const BodyMesh mesh(square_mesh(8));
    const auto two = [&](double gap) {
        const std::vector<CrackSection> cracks{{.points = {{0.0, 0.43}, {0.5, 0.43}}, .contact = {}},
                                               {.points = {{0.0, 0.43 + gap}, {0.5, 0.43 + gap}}, .contact = {}}};
        return coarse::enrich(mesh, cracks, {6, 0.5});
    };
    EXPECT_THROW(two(0.01), CaseError);
    EXPECT_THROW(two(0.125), CaseError);  // neighbouring elements share nodes: sides would mix
    EXPECT_NO_THROW(two(0.375));
    EXPECT_THROW(cracked(mesh, {{0.4, 0.4}, {0.45, 0.4}}), CaseError);
    EXPECT_THROW(cracked(mesh, {{0.4, 0.4}, {0.52, 0.4}}), CaseError);
    const std::string said = test::refusal_of([] { return cracked(square_mesh(3), {{0.4, 0.4}, {0.6, 0.4}}); });
    EXPECT_NE(said.find("(0.333333, 0.333333)"), std::string::npos) << said;
    EXPECT_NO_THROW(cracked(mesh, {{0.4, 0.4}, {0.7, 0.4}}));
}

// Functions of two tips meet in time. Where faces end on edges cracks grew into each other, hung together by a node,
// passed each other, and the run ended with a crash of the coarse component (exit code 139).
TEST(Enrichment, CracksWithoutFunctionsDoNotMeet) {
    const auto with_tips_at = [](double left, double right) {
        return coarse::enrich(BodyMesh(square_mesh(10)),
                              {{.points = {{0.0, 0.5}, {left, 0.5}}, .contact = {}},
                               {.points = {{1.0, 0.5}, {right, 0.5}}, .contact = {}}},
                              {.functions = 0, .exponent = 0.5});
    };
    EXPECT_EQ(with_tips_at(0.4, 0.5).tips.size(), 2U) << "an element is between them";
    for (const auto& [left, right] : {std::pair(0.5, 0.5), {0.46, 0.54}, {0.52, 0.48}, {0.8, 0.2}})
        EXPECT_NE(test::refusal_of([&] { return with_tips_at(left, right); }).find("less than two elements from"),
                  std::string::npos)
            << left;
}

}  // namespace
}  // namespace stria::test
