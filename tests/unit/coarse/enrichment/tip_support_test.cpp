// The nodes about a tip, and how large a disk of them is.
#include "coarse/enrichment/tip_support.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "common/error.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/refined_squares.hpp"

namespace stria::coarse {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

RoomOfDisk room_of(double in_body, double other_end, double other_cracks, double diagonal) {
    return {.of_others = {},
            .in_body = in_body,
            .other_end = other_end,
            .other_cracks = other_cracks,
            .diagonal = diagonal};
}

/// Of a 4 x 4 mesh of the unit square.
int node_of_16(int column, int row) { return 5 * row + column; }

TEST(TipSupport, HasBothElementsOfATipOnAnEdge) {
    CrackPiece piece{.crack = 0, .element = 5, .points = {}, .s = {}};
    const BodyMesh mesh(test::square_mesh(4));
    EXPECT_EQ(tip_nodes(mesh, piece),
              (std::set{node_of_16(1, 1), node_of_16(2, 1), node_of_16(1, 2), node_of_16(2, 2)}));
    piece.neighbour = 9;
    EXPECT_EQ(tip_nodes(mesh, piece), (std::set{node_of_16(1, 1), node_of_16(2, 1), node_of_16(1, 2), node_of_16(2, 2),
                                                node_of_16(1, 3), node_of_16(2, 3)}));
}

// Two elements, the right one split in four.
TEST(TipSupport, HasTheEndsOfTheEdgeOnWhichANodeOfItHangs) {
    const Mesh mesh = test::refined(grid_mesh(std::vector{0.0, 1.0, 2.0}, std::vector{0.0, 1.0}),
                                    {{{1.5, 0.5}, {1.5, 0.5}, 0.1, 1, 0.0}})
                          .mesh;
    ASSERT_EQ(mesh.hanging.size(), 1U);
    const auto [hanging, ends, larger] = mesh.hanging.front();
    for (int e = 0; e < std::ssize(mesh.elements); ++e) {
        const auto& corners = mesh.elements[at(e)];
        const bool touches = std::ranges::find(corners, hanging) != corners.end();
        const std::set<int> nodes = tip_nodes(mesh, {.crack = 0, .element = e, .points = {}, .s = {}});
        EXPECT_EQ(nodes.size(), touches ? 5U : 4U) << e;  // one end is a corner anyway
        for (const int end : ends) EXPECT_TRUE(!touches || nodes.contains(end)) << e;
    }
}

// Centres lie at 0.125, 0.375, ...
TEST(TipSupport, OfADiskIsWholeElements) {
    const BodyMesh mesh(test::square_mesh(4));
    std::set<int> nodes;
    add_disk(mesh, {0.375, 0.375}, 0.24, nodes);
    EXPECT_EQ(nodes.size(), 4U);
    add_disk(mesh, {0.375, 0.375}, 0.26, nodes);  // and those beside it
    EXPECT_EQ(nodes.size(), 12U);
    EXPECT_FALSE(nodes.contains(node_of_16(0, 0)));
    EXPECT_TRUE(nodes.contains(node_of_16(1, 0)));
}

TEST(TipSupport, ReachesThreeQuartersOfTheWayKeepsClearOfOthersAndIsNotLargerThanPays) {
    const Tip tip{};
    const TipEnrichment tips{.most_diagonals = 20.0};
    EXPECT_DOUBLE_EQ(disk_radius(tips, tip, room_of(8.0, infinite, infinite, 1.0)), 6.0);
    EXPECT_DOUBLE_EQ(disk_radius(tips, tip, room_of(8.0, 3.0, infinite, 1.0)), 1.75);
    EXPECT_DOUBLE_EQ(disk_radius(tips, tip, room_of(8.0, infinite, 3.0, 1.0)), 1.75);
    EXPECT_DOUBLE_EQ(disk_radius(tips, tip, room_of(8.0, infinite, 8.0, 0.25)), 5.0);
}

TEST(TipSupport, ReachesTheElementsAboutATipOnAnEdgeWhereThereIsRoom) {
    const Tip tip{};
    const TipEnrichment tips{.most_diagonals = 20.0};
    EXPECT_DOUBLE_EQ(disk_radius(tips, tip, room_of(1.4, infinite, infinite, 1.0)), 1.15);
    EXPECT_DOUBLE_EQ(disk_radius(tips, tip, room_of(1.1, infinite, infinite, 1.0)), 1.1);
    EXPECT_DOUBLE_EQ(disk_radius(tips, tip, room_of(1.6, infinite, infinite, 1.0)), 1.2);
    EXPECT_DOUBLE_EQ(disk_radius(tips, tip, room_of(1.4, 2.0, infinite, 1.0)), 0.75) << "clear of others";
}

TEST(TipSupport, IsAsLargeAsTheCaseSaysOrTheCaseIsRefused) {
    TipEnrichment tips{.radius = 2.0};
    const RoomOfDisk room = room_of(2.0, 2.0, infinite, 1.0);
    const Tip tip{.crack = 0, .position = {3.0, 5.0}, .direction = Vec2::UnitX(), .s = 3.0, .upper = 1};
    EXPECT_EQ(disk_radius(tips, tip, room), 2.0);
    tips.radius = 2.01;
    EXPECT_THROW(static_cast<void>(disk_radius(tips, tip, room)), CaseError);
}

/// In the middle of 12 x 12 elements of 1 mm.
TipNodes about_tip(TipSupport support, double in_body, double other_end, std::set<int> of_others = {}) {
    const BodyMesh mesh(test::square_mesh(12, 12.0));
    const Tip tip{.crack = 0, .position = {5.5, 5.5}, .direction = Vec2::UnitX(), .s = 3.0, .upper = 1};
    const CrackPiece piece{.crack = 0, .element = 5 * 12 + 5, .points = {}, .s = {}};
    RoomOfDisk room = room_of(in_body, other_end, infinite, std::numbers::sqrt2);
    room.of_others = std::move(of_others);
    return support_of_tip(mesh, {.support = support, .most_diagonals = 1.2}, tip, piece, room);
}

// The last nodes of the elements about the tip's are 1.5 sqrt(2) = 2.12 mm away.
TEST(TipSupport, SharesFunctionsAmongAllElementsAboutTheTipsOrHasThemOnThatAlone) {
    const auto shared = [](double other_end) {
        const TipNodes found = about_tip(TipSupport::Gathered, 5.0, other_end);
        EXPECT_EQ(found.nodes.size(), found.share ? 16U : 4U);
        return found.share;
    };
    EXPECT_TRUE(shared(2.13)) << "no node of the crack's other tip";
    EXPECT_FALSE(shared(2.11));
    EXPECT_TRUE(about_tip(TipSupport::Gathered, 1.2, infinite).share) << "the boundary takes none";
    EXPECT_FALSE(about_tip(TipSupport::Nodal, 5.0, infinite).share);
    EXPECT_FALSE(about_tip(TipSupport::Topological, 5.0, infinite).share);
}

// Nodes in columns 4 to 7 are those of the elements about the tip's. No element sees two cracks: half of the way to the
// other one, less half an element, asked for seven elements of distance where four are enough.
TEST(TipSupport, SharesThemUnlessAnElementSeesAnotherCrackAndLeavesOutWhatDoes) {
    const auto beside_crack = [](int column) {
        std::set<int> nodes;
        for (int row = 0; row <= 12; ++row) nodes.insert(13 * row + column);
        return about_tip(TipSupport::Gathered, 5.0, infinite, std::move(nodes));
    };
    EXPECT_TRUE(beside_crack(9).share);
    EXPECT_EQ(beside_crack(9).nodes.size(), 16U);
    EXPECT_FALSE(beside_crack(8).share);
    EXPECT_EQ(beside_crack(8).nodes.size(), 12U);
    EXPECT_FALSE(beside_crack(8).nodes.contains(13 * 5 + 7));
    EXPECT_EQ(beside_crack(7).nodes.size(), 4U) << "the tip's element is beside the crack's";
}

// Two tips six elements apart, and what is nearer to either.
TEST(TipSupport, LeavesToAnotherTipWhatIsNearerToIt) {
    const BodyMesh mesh(test::square_mesh(12, 12.0));
    const auto crack = [&](double from, double to, bool at_start) {
        CrackPath path;
        path.pieces = {
            {.crack = 0, .element = 5 * 12 + (at_start ? 7 : 3), .points = {{from, 5.5}, {to, 5.5}}, .s = {}}};
        path.tip_at_start = at_start;
        path.tip_at_end = !at_start;
        return nodes_of_crack(mesh, path);
    };
    const std::vector<NodesOfCrack> cracks{crack(3.0, 3.2, false), crack(7.4, 8.0, true)};
    const Tip tip{.crack = 0, .position = {3.2, 5.5}, .direction = Vec2::UnitX(), .s = 3.0, .upper = 1};
    const std::set<int> left = left_to_others(mesh, cracks, tip);
    EXPECT_EQ(left.size(), 16U) << "columns 6 to 9";
    EXPECT_TRUE(left.contains(13 * 5 + 6));
    EXPECT_FALSE(left.contains(13 * 5 + 5));
}

}  // namespace
}  // namespace stria::coarse
