// Cracks resolved on a mesh: which elements they pass, where they enter and leave, and what is refused.
#include "common/crack/crack_crossings.hpp"
#include "common/crack/crack_path.hpp"
#include "common/crack/straight_way.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/fem/shape_q4.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/refined_squares.hpp"

namespace stria::test {
namespace {

using Points = std::vector<Vec2>;

double length_of(const std::vector<CrackPiece>& pieces) {
    double length = 0.0;
    for (const CrackPiece& piece : pieces) {
        for (std::size_t k = 1; k < piece.points.size(); ++k) length += (piece.points[k] - piece.points[k - 1]).norm();
    }
    return length;
}

/// Of a place on an element's boundary: edge index + fraction of the edge.
Vec2 boundary_point(const QuadNodes& nodes, double place) {
    const auto edge = static_cast<std::size_t>(place);
    const double fraction = place - static_cast<double>(edge);
    return (1.0 - fraction) * nodes[edge % 4] + fraction * nodes[(edge + 1) % 4];
}

/// Pieces follow one another without a gap, and lie on their elements' boundaries where they say so.
void expect_chain(const Mesh& mesh, const CrackPath& path) {
    for (std::size_t k = 0; k < path.pieces.size(); ++k) {
        const CrackPiece& piece = path.pieces[k];
        ASSERT_EQ(piece.points.size(), piece.s.size());
        const auto corners = corners_of_element(mesh, piece.element);
        const Vec2 entry = piece.entry >= 0.0 ? boundary_point(corners, piece.entry) : piece.points.front();
        const Vec2 exit = piece.exit >= 0.0 ? boundary_point(corners, piece.exit) : piece.points.back();
        EXPECT_LT((entry - piece.points.front()).norm() + (exit - piece.points.back()).norm(), 1e-12);
        if (k == 0) continue;
        EXPECT_EQ(path.pieces[k - 1].points.back(), piece.points.front());
        EXPECT_EQ(path.pieces[k - 1].s.back(), piece.s.front());
    }
}

TEST(CrackPath, PiecesCoverTheCrack) {
    const Mesh mesh = distorted(square_mesh(7), 0.02);
    for (const Points& crack : {Points{{0.0, 0.43}, {0.62, 0.47}}, Points{{0.21, 0.18}, {0.55, 0.52}, {0.83, 0.61}}}) {
        const CrackPath path = path_on(mesh, crack);
        expect_chain(mesh, path);
        EXPECT_NEAR(length_of(path.pieces), path.length, 1e-12);
        EXPECT_EQ(path.pieces.front().s.front(), 0.0);
        EXPECT_EQ(path.pieces.back().s.back(), path.length);
    }
}

// Whatever the position and angle, steep or nearly parallel to mesh lines: snapping moves a crack by 1e-2 of an
// element.
TEST(CrackPath, EveryStraightCrackIsResolved) {
    const Mesh mesh = square_mesh(10);
    for (int k = 0; k < 2000; ++k) {
        const double slope =
            0.7 * std::pow(10.0, -5.0 + 5.0 * std::fmod(k * std::numbers::sqrt2, 1.0)) * (k % 2 == 0 ? 1.0 : -1.0);
        const double crosses = std::fmod(k * std::numbers::phi, 0.6);  // the mesh line at half height
        const Points crack{{-0.1, 0.5 - slope * (crosses + 0.1)}, {0.62, 0.5 + slope * (0.62 - crosses)}};
        const CrackPath path = path_on(mesh, crack);
        expect_chain(mesh, path);
        EXPECT_NEAR(length_of(path.pieces), 0.62 * std::hypot(1.0, slope), 2e-3) << k << " slope " << slope;
    }
}

// What has not changed is told by that when a crack has grown.
TEST(CrackPath, KeepsItsPiecesToTheBitWhereItGoesStraightOn) {
    const std::vector<double> wide = equal_cells(413, 50.0);
    std::vector<double> high;
    for (int k = 0; k <= 60; ++k) high.push_back(96.8 + 0.121 * k);
    for (const bool along_x : {true, false})
        for (const double slope : {0.0, 1.7e-4, -0.03, 0.1}) {
            // Nodes are off by rounding, as those of split elements are.
            const Mesh mesh = distorted(along_x ? coarse::grid_mesh(wide, high) : coarse::grid_mesh(high, wide), 4e-15);
            const auto turned = [&](const Vec2& x) { return along_x ? x : Vec2(x.reverse()); };
            const Vec2 kink = turned({3.0, 100.03}), end = kink + 26.56 * turned({1.0, slope}).normalized();
            Points points{turned({0.0, 100.03}), kink, on_rounded_way(kink, end)};
            const std::vector<CrackPiece> before = path_on(mesh, points).pieces;
            for (int growth = 1; growth < 20; ++growth) {
                points[2] = on_rounded_way(points[1], points[2] + 0.02 * (points[2] - points[1]).normalized());
                const std::vector<CrackPiece> after = path_on(mesh, points).pieces;
                ASSERT_GE(after.size(), before.size());
                for (std::size_t k = 0; k + 1 < before.size(); ++k) {  // the last one ends at the tip
                    EXPECT_EQ(after[k].points, before[k].points) << slope << ", " << growth << ", piece " << k;
                    EXPECT_EQ(after[k].s, before[k].s);
                }
            }
        }
}

TEST(CrackPath, MouthOutsideTheBodyIsCutOff) {
    const CrackPath path = path_on(square_mesh(5), {{-0.3, 0.47}, {0.52, 0.47}});
    EXPECT_FALSE(path.tip_at_start);
    EXPECT_TRUE(path.tip_at_end);
    EXPECT_NEAR(path.pieces.front().s.front(), 0.3, 1e-15);
    EXPECT_EQ(path.pieces.front().points.front(), Vec2(0.0, 0.47));
    EXPECT_EQ(path.pieces.size(), 3U);
    EXPECT_EQ(path.pieces.back().exit, -1.0);
}

TEST(CrackPath, ThroughBodyHasNoTips) {
    const CrackPath path = path_on(square_mesh(5), {{-0.1, 0.31}, {1.1, 0.74}});
    EXPECT_FALSE(path.tip_at_start || path.tip_at_end);
    EXPECT_NEAR(length_of(path.pieces), std::hypot(1.0, 0.43 / 1.2), 1e-12);
}

TEST(CrackPath, PassesThroughNodes) {
    const CrackPath path = path_on(square_mesh(4), {{0.0, 0.0}, {0.625, 0.625}});
    ASSERT_EQ(path.pieces.size(), 3U);
    EXPECT_EQ(path.pieces[1].element, 5);
    EXPECT_EQ(path.pieces[1].entry, 0.0);
    EXPECT_EQ(path.pieces[1].exit, 2.0);
}

TEST(CrackPath, RunsAlongEdgesWithTheElementOnItsRight) {
    const CrackPath path = path_on(square_mesh(4), {{0.0, 0.5}, {0.75, 0.5}});
    ASSERT_EQ(path.pieces.size(), 3U);
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(path.pieces[at(k)].element, 4 + k);
        EXPECT_EQ(path.pieces[at(k)].neighbour, 8 + k);
    }
}

// Elements on one side are twice as large, and rounding puts the crack on their side of the nodes that hang there.
TEST(CrackPath, RunsAlongHalvesOfEdgesWhereverRoundingPutsIt) {
    constexpr double h = 1.0 / 48.0;
    for (const double split : {0.43, 0.5}) {
        const Mesh mesh = refined(square_mesh(6), {{{split, 0.5}, {split, 0.5}, 0.05, 3, 0.2}}).mesh;
        for (const auto& [across, up] : {std::pair{12, 11}, {12, 20}, {12, 28}, {18, 22}, {18, 26}, {22, 22}, {22, 26}})
            for (const double mouth : {0.0, 1.0}) {
                const CrackPath path = path_on(mesh, {{across * h, mouth}, {across * h, up * h}});
                expect_chain(mesh, path);
                EXPECT_NEAR(length_of(path.pieces), std::abs(up * h - mouth), 1e-9)
                    << split << ' ' << across << ' ' << up;
            }
    }
}

TEST(CrackPath, EndsInsideAnEdgeThatItRunsAlong) {
    const CrackPath path = path_on(square_mesh(4), {{0.0, 0.5}, {0.6, 0.5}});
    ASSERT_EQ(path.pieces.size(), 3U);
    EXPECT_EQ(path.pieces.back().element, 6);
    EXPECT_EQ(path.pieces.back().neighbour, 10);
    EXPECT_EQ(path.pieces.back().points.back(), Vec2(0.6, 0.5));
}

TEST(CrackPath, SnapsOntoNearbyNodes) {
    const double off = 0.5 * snap_fraction * 0.25;
    const CrackPath path = path_on(square_mesh(4), {{0.0, 0.5 + off}, {1.0, 0.5 - off}});
    ASSERT_EQ(path.pieces.size(), 4U);
    for (const CrackPiece& piece : path.pieces) EXPECT_GE(piece.neighbour, 0);
    for (const CrackPiece& piece : path.pieces) EXPECT_EQ(piece.points.back().y(), 0.5);
}

// The crack passes the node at 0.3e-3 of an edge, and its tip lies as near beyond it, or beside it: the piece from the
// node to the tip would run anywhere, even back.
TEST(CrackPath, PutsPointsBesideANodeOntoIt) {
    const double hair = 0.25 * 0.3e-3;
    const Vec2 from(0.1, 0.3), at_node(0.5, 0.5);
    for (const Vec2& off :
         {Vec2(hair, -hair), Vec2(hair, 0.0), Vec2(0.0, hair), Vec2(-hair, hair), Vec2(1e-9, -1e-9)}) {
        const CrackPath ends = path_on(square_mesh(4), {from, at_node + off});
        EXPECT_EQ(ends.points.back(), at_node);
        EXPECT_TRUE(ends.tip_at_end);
        EXPECT_EQ(ends.pieces.back().points.back(), at_node);
        EXPECT_EQ(ends.pieces.back().exit, 2.0);
        const CrackPath bent = path_on(square_mesh(4), {from, at_node + off, at_node - off, {0.9, 0.55}});
        EXPECT_EQ(bent.points, (Points{from, at_node, {0.9, 0.55}}));
        for (const CrackPiece& piece : bent.pieces) EXPECT_EQ(piece.points.size(), 2U);
    }
    const Vec2 beyond = at_node + Vec2(0.25 * 1.1e-3, 0.0);
    EXPECT_EQ(path_on(square_mesh(4), {from, beyond}).points.back(), beyond);
    const Points tiny{at_node, at_node + Vec2(hair, hair)};
    EXPECT_EQ(path_on(square_mesh(4), tiny).points, tiny);  // nothing else would be left of it
}

// Whatever side rounding puts it on: the element that holds a tip on its edge has its functions.
TEST(CrackPath, PutsATipBesideAnEdgeOntoIt) {
    for (const double hair : {0.0, 1e-16, 1e-11, -1e-11, 1e-7, -1e-7}) {
        const CrackPath path = path_on(square_mesh(4), {{0.1, 0.3}, {0.6, 0.5 + hair}});
        EXPECT_EQ(path.points.back(), Vec2(0.6, 0.5)) << hair;
        EXPECT_EQ(path.pieces.back().element, 6) << hair;
        EXPECT_GE(path.pieces.back().exit, 0.0) << hair;
        EXPECT_TRUE(path.tip_at_end);
    }
}

// A hair beside an edge that it runs along, a crack would cut a sliver off the element there.
TEST(CrackPath, PutsPointsBesideAnEdgeOntoIt) {
    for (const double hair : {1e-7, -1e-7}) {
        const CrackPath path = path_on(square_mesh(4), {{0.0, 0.5}, {0.6, 0.5 + hair}});
        EXPECT_EQ(path.points.back(), Vec2(0.6, 0.5));
        for (const CrackPiece& piece : path.pieces) EXPECT_GE(piece.neighbour, 0);
    }
    for (const double hair : {1e-7, 3e-12, 1e-16})  // a kink in mid-edge
        EXPECT_EQ(path_on(square_mesh(4), {{0.0, 0.5}, {0.6, 0.5 + hair}, {0.9, 0.6}}).pieces[2].points.back(),
                  Vec2(0.6, 0.5));
    const Vec2 tip(0.6, 0.5 + 1e-5);
    EXPECT_EQ(path_on(square_mesh(4), {{0.1, 0.3}, tip}).points.back(), tip);
}

// In a body that is turned, the ends of a crack across it lie on the outline to rounding only.
TEST(CrackPath, AnEndOnASlantedOutlineIsAMouth) {
    for (int k = 0; k < 200; ++k) {
        Mesh mesh = square_mesh(4);
        const Eigen::Rotation2Dd turn(0.031 * k);
        for (Vec2& node : mesh.nodes) node = turn * node;
        const CrackPath path = path_on(mesh, {turn * Vec2(0.0, 0.3 + 1e-3 * k), turn * Vec2(0.55, 0.4)});
        EXPECT_FALSE(path.tip_at_start) << k;
        EXPECT_TRUE(path.tip_at_end);
        EXPECT_GE(path.pieces.front().entry, 0.0);
    }
}

TEST(CrackPath, BothTipsInsideOneElement) {
    const CrackPath path = path_on(square_mesh(3), {{0.4, 0.5}, {0.6, 0.55}});
    ASSERT_EQ(path.pieces.size(), 1U);
    EXPECT_TRUE(path.tip_at_start && path.tip_at_end);
    EXPECT_EQ(path.pieces[0].element, 4);
    EXPECT_EQ(path.pieces[0].entry, -1.0);
    EXPECT_EQ(path.pieces[0].exit, -1.0);
}

TEST(CrackPath, TipOnAnEdgeEndsThere) {
    const CrackPath path = path_on(square_mesh(4), {{0.0, 0.4}, {0.5, 0.4}});
    ASSERT_EQ(path.pieces.size(), 2U);
    EXPECT_TRUE(path.tip_at_end);
    EXPECT_NEAR(path.pieces.back().exit, 1.6, 1e-12);
}

TEST(CrackPath, KeepsKinksInsideElements) {
    const CrackPath path = path_on(square_mesh(3), {{0.0, 0.5}, {0.45, 0.5}, {0.9, 0.6}});
    ASSERT_EQ(path.pieces.size(), 3U);
    ASSERT_EQ(path.pieces[1].points.size(), 3U);
    EXPECT_EQ(path.pieces[1].points[1], Vec2(0.45, 0.5));
    EXPECT_DOUBLE_EQ(path.pieces[1].s[1], 0.45);
}

TEST(CrackPath, RefusesWhatTheMeshCannotHold) {
    const Mesh mesh = square_mesh(4);
    EXPECT_THROW(path_on(mesh, {{1.2, 0.5}, {1.6, 0.5}}), CaseError);              // outside
    EXPECT_THROW(path_on(mesh, {{0.0, 0.4}, {0.4, 0.4}, {0.0, 0.3}}), CaseError);  // one element twice
    EXPECT_THROW(path_on(mesh, {{0.1, 0.4}, {0.55, 0.5}, {0.7, 0.5}, {0.9, 0.6}}),
                 CaseError);                                                       // comes and goes
    EXPECT_THROW(path_on(mesh, {{0.0, 0.0}, {1.0, 0.0}}), CaseError);              // along the boundary
    EXPECT_THROW(path_on(mesh, {{0.1, 0.4}, {0.6, 0.4}, {0.5, 0.6}}), CaseError);  // turns back
    EXPECT_NO_THROW(path_on(mesh, {{0.1, 0.4}, {0.6, 0.4}, {0.6, 0.6}}));
}

// From the node where it comes to the edge up to the bend it has an element on either side, and then cuts one of them.
TEST(CrackPath, LeavesAnEdgeInItsMiddle) {
    for (const auto& [end, element] : {std::pair{Vec2(0.65, 0.52), 10}, {Vec2(0.65, 0.48), 6}}) {
        for (const bool backwards : {false, true}) {
            Points points{{0.0, 0.5}, {0.6, 0.5}, end};
            if (backwards) std::ranges::reverse(points);
            CrackPath path = path_on(square_mesh(4), points);
            ASSERT_EQ(path.pieces.size(), 4U);
            if (backwards) std::ranges::reverse(path.pieces);
            const CrackPiece &along = path.pieces[2], &last = path.pieces[3];
            EXPECT_EQ(std::minmax(along.element, along.neighbour), std::minmax(6, 10));
            EXPECT_EQ(last.element, element);
            EXPECT_EQ(last.neighbour, -1);
            EXPECT_NEAR(backwards ? last.exit : last.entry, element == 10 ? 0.4 : 2.6, 1e-12);
            EXPECT_EQ(backwards ? along.points.front() : along.points.back(), Vec2(0.6, 0.5));
        }
    }
}

// Whichever side of a slanted edge rounding puts the bend on.
TEST(CrackPath, LeavesASlantedEdgeInItsMiddle) {
    Mesh mesh = square_mesh(4);
    for (Vec2& x : mesh.nodes) x.x() += 0.137 * x.y();
    const auto slanted = [](double x, double y) { return Vec2(x + 0.137 * y, y); };
    for (int k = 1; k < 20; ++k) {
        const Vec2 bend = slanted(0.5, 0.25 + 0.0125 * k);
        for (const double to : {0.05, -0.05}) {
            const CrackPath path = path_on(mesh, {slanted(0.1, 0.15), slanted(0.5, 0.25), bend, bend + Vec2(to, 0.05)});
            const auto along = std::ranges::find_if(path.pieces, [](const CrackPiece& p) { return p.neighbour >= 0; });
            ASSERT_NE(along, path.pieces.end()) << k;
            EXPECT_LT((along->points.back() - bend).norm(), 1e-12) << k;
            EXPECT_EQ((along + 1)->element, to > 0.0 ? 6 : 5) << k;
        }
    }
}

}  // namespace
}  // namespace stria::test
