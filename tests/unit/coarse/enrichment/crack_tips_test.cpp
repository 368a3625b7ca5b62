// The ends of a crack inside the body, their frames, and what lies behind them.
#include "coarse/enrichment/crack_tips.hpp"

#include <gtest/gtest.h>

#include "coarse/enrichment/crack_front.hpp"
#include "common/error.hpp"
#include "tests/support/cracked_mesh.hpp"

namespace stria::coarse {
namespace {

/// Of a 4 x 4 mesh of the unit square.
CrackPath path_along(const std::vector<Vec2>& points) { return test::path_on(test::square_mesh(4), points); }

TEST(CrackTips, OfAnInnerCrackBothPointOutOfIt) {
    Mesh mesh = test::square_mesh(4);
    mesh.material.assign(16, 0);
    mesh.material[4] = 2;  // at the start
    mesh.material[7] = 1;  // at the end
    const CrackPath path = test::path_on(mesh, {{0.1, 0.3}, {0.5, 0.4}, {0.9, 0.4}});
    const std::vector<Tip> tips = tips_of(mesh, path);
    ASSERT_EQ(tips.size(), 2U);
    EXPECT_EQ(tips[0].position, Vec2(0.1, 0.3));
    EXPECT_LT((tips[0].direction - Vec2(-0.4, -0.1).normalized()).norm(), 1e-15);
    EXPECT_LT((tips[1].direction - Vec2(1.0, 0.0)).norm(), 1e-15);
    EXPECT_EQ(tips[1].position, Vec2(0.9, 0.4));
    EXPECT_EQ(tips[0].s, 0.0);
    EXPECT_NEAR(tips[1].s, path.length, 1e-15);
    EXPECT_NEAR(path.length, std::hypot(0.4, 0.1) + 0.4, 1e-15);
    // The plus side is left of the way from the first point on: right of who looks out of the start.
    EXPECT_EQ(tips[0].upper, -1);
    EXPECT_EQ(tips[1].upper, 1);
    EXPECT_EQ(tips[0].material, 2);
    EXPECT_EQ(tips[1].material, 1);
    for (const Tip& tip : tips) EXPECT_NEAR(tip.beyond, 0.0, 1e-15);
    EXPECT_EQ(last_piece(path, tips[0]).element, 4);
    EXPECT_EQ(last_piece(path, tips[1]).element, 7);
}

TEST(CrackTips, OfAnEdgeCrackIsTheEndThatLiesInside) {
    const Mesh mesh = test::square_mesh(4);
    const std::vector<Tip> from_left = tips_of(mesh, path_along({{0.0, 0.4}, {0.6, 0.4}})),
                           to_left = tips_of(mesh, path_along({{0.6, 0.4}, {0.0, 0.4}}));
    ASSERT_EQ(from_left.size(), 1U);
    ASSERT_EQ(to_left.size(), 1U);
    EXPECT_EQ(from_left[0].position, to_left[0].position);
    EXPECT_EQ(from_left[0].direction, to_left[0].direction);
    EXPECT_EQ(from_left[0].upper, -to_left[0].upper);
}

// A tip just behind a node, which has pulled the beginning of its last piece onto itself.
TEST(CrackTips, LookWhereTheCrackIsGivenToGo) {
    const Vec2 bend(0.3, 0.3002), end(0.51, 0.5102);
    const std::vector<Tip> tips = tips_of(test::square_mesh(4), path_along({{0.0, 0.3}, bend, end}));
    ASSERT_EQ(tips.size(), 1U);
    EXPECT_LT((tips[0].direction - (end - bend).normalized()).norm(), 1e-12);
}

// At the end on edges that it moves to, the faces end 0.14 mm before one tip and 0.11 mm beyond the other.
TEST(CrackTips, AreAsFarBeyondTheirFacesAsThoseHaveMoved) {
    const BodyMesh mesh(test::square_mesh(4));
    const CrackPath path = with_fronts_on_edges(mesh, path_along({{0.36, 0.4}, {0.85, 0.4}}));
    const std::vector<Tip> tips = tips_of(mesh, path);
    ASSERT_EQ(tips.size(), 2U);
    for (const Tip& tip : tips) {
        const CrackPiece& piece = last_piece(path, tip);
        const Vec2 front = tip.upper < 0 ? piece.points.front() : piece.points.back();
        EXPECT_NEAR(tip.beyond, (tip.position - front).dot(tip.direction), 1e-14);
        EXPECT_GT(std::abs(tip.beyond), 0.05);
    }
}

TEST(CrackTips, HaveTheirCrackBehindThem) {
    const Mesh mesh = test::square_mesh(8);
    const auto require = [&](const std::vector<Vec2>& points) {
        const CrackPath path = test::path_on(mesh, points);
        for (const Tip& tip : tips_of(mesh, path)) require_behind(mesh, path, tip);
    };
    const Vec2 mouth(0.0, 0.55);
    EXPECT_NO_THROW(require({mouth, {0.45, 0.55}, {0.7, 0.7}}));
    EXPECT_NO_THROW(require({mouth, {0.45, 0.55}, {0.45, 0.7}}));
    // A hook within two elements of its tip: part of it lies ahead. One whose arms are long has it out of reach.
    const std::vector<Vec2> hook{mouth, {0.47, 0.55}, {0.55, 0.6}, {0.55, 0.66}, {0.45, 0.7}};
    EXPECT_THROW(require(hook), CrackOffMesh);
    EXPECT_NO_THROW(require({mouth, {0.3, 0.55}, {0.8, 0.55}, {0.8, 0.9}, {0.6, 0.95}}));
    // It turns back within its last element, and yet no point of it lies ahead.
    EXPECT_THROW(require({{0.36, 0.0}, {0.36, 0.53}, {0.48, 0.55}, {0.48, 0.57}, {0.43, 0.62}}), CrackOffMesh);
}

}  // namespace
}  // namespace stria::coarse
