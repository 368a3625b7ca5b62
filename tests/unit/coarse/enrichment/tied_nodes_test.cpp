// Sides and jumps of a node that hangs between a square and two half as large, for cracks about it.
#include "coarse/enrichment/tied_nodes.hpp"

#include <gtest/gtest.h>

#include <map>

#include "common/fem/centre.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/refined_squares.hpp"

namespace stria::coarse {
namespace {

/// The square [0, 1]^2, and [1, 2] x [0, 1] in four parts: a node hangs at (1, 1/2).
class TiedNodes : public testing::Test {
protected:
    TiedNodes() {
        const Mesh mesh = test::refined(grid_mesh(std::vector{0.0, 1.0, 2.0}, std::vector{0.0, 1.0}),
                                        {{{1.5, 0.5}, {1.5, 0.5}, 0.1, 1, 0.0}})
                              .mesh;
        hanging_ = mesh.hanging;
        cracked_.nodes = mesh.nodes;
        cracked_.elements = mesh.elements;
        cracked_.terms = TermsOfNodes(mesh.nodes.size());
        cracked_.element_side.assign(mesh.elements.size(), 0);
    }

    [[nodiscard]] int node_at(const Vec2& x) const {
        return static_cast<int>(std::ranges::find(cracked_.nodes, x) - cracked_.nodes.begin());
    }
    void jump_at(const Vec2& x, double side) {
        cracked_.terms.of(at(node_at(x))).push_back({Term::Kind::Heaviside, 0, 0, side});
    }
    /// A piece of a crack in the element, which comes in at a place and ends inside.
    void meet(int element, double place, int neighbour = -1) {
        cracked_.pieces.push_back(
            {.crack = 0, .element = element, .neighbour = neighbour, .points = {}, .s = {}, .entry = place});
    }
    /// In the element: of its corner at x.
    [[nodiscard]] double corner(int element, const Vec2& x) const {
        return static_cast<double>(std::ranges::find(cracked_.elements[at(element)], node_at(x)) -
                                   cracked_.elements[at(element)].begin());
    }
    [[nodiscard]] TiedNode tied() const {
        const std::vector<TiedNode> all = tied_nodes(hanging_, cracked_, beside_);
        EXPECT_EQ(all.size(), 1U);
        return all.at(0);
    }
    [[nodiscard]] int small_above() const {
        for (int e = 1; e < std::ssize(cracked_.elements); ++e)
            if (centre(cracked_, e) == Vec2(1.25, 0.75)) return e;
        return -1;
    }

    std::vector<HangingNode> hanging_;
    EnrichedMesh cracked_;
    std::map<int, int> beside_;
    const Vec2 below_{1.0, 0.0}, middle_{1.0, 0.5}, above_{1.0, 1.0};
};

TEST_F(TiedNodes, FarFromCracksHasNoSideAndNoJump) {
    EXPECT_EQ(tied().node, node_at(middle_));
    EXPECT_EQ((std::set{tied().ends[0], tied().ends[1]}), (std::set{node_at(below_), node_at(above_)}));
    EXPECT_EQ(tied().side, 0.0);
    EXPECT_FALSE(tied().jump_tied);
}

TEST_F(TiedNodes, JumpsWhereACrackMeetsTheEdgeInTheLargerOrInASmallElement) {
    meet(0, corner(0, below_) + 0.3);
    EXPECT_TRUE(tied().jump_tied);
    cracked_.pieces.clear();
    meet(small_above(), corner(small_above(), above_) + 0.3);  // from there down to the hanging node
    EXPECT_TRUE(tied().jump_tied);
    cracked_.pieces.clear();
    meet(small_above(), corner(small_above(), middle_));
    EXPECT_TRUE(tied().jump_tied);
    cracked_.pieces.clear();
    meet(small_above(), corner(small_above(), middle_) + 0.3);  // away from the edge
    EXPECT_FALSE(tied().jump_tied);
    cracked_.pieces.clear();
    meet(0, corner(0, above_));  // an end does not make the middle jump
    EXPECT_FALSE(tied().jump_tied);
}

TEST_F(TiedNodes, IsOnTheSideThatIsKnownThenOnThatOfAnEnd) {
    jump_at(below_, -1.0);
    EXPECT_EQ(tied().side, -1.0);
    beside_[node_at(middle_)] = 1;
    EXPECT_EQ(tied().side, 1.0);
}

// A node on the crack counts as +, though what lies beside it may be on the other side.
TEST_F(TiedNodes, DoesNotAskAnEndThatLiesOnTheCrack) {
    cracked_.element_side[0] = -1;
    meet(0, corner(0, below_));
    jump_at(below_, 1.0);
    EXPECT_EQ(tied().side, -1.0);
    jump_at(above_, 1.0);
    EXPECT_EQ(tied().side, 1.0);
}

// The crack runs along the edge from its end to the hanging node: what hangs is not on the larger element's side.
TEST_F(TiedNodes, IsBeyondAnEdgeThatTheCrackRunsAlong) {
    cracked_.element_side[0] = -1;
    EXPECT_EQ(tied().side, -1.0);
    meet(0, corner(0, below_) + 0.5);  // across it
    EXPECT_EQ(tied().side, -1.0);
    meet(0, corner(0, below_) + 0.5, small_above());
    EXPECT_EQ(tied().side, 1.0);
}

}  // namespace
}  // namespace stria::coarse
