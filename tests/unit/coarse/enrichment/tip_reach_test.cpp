// How far about a tip its field reaches, and how far behind it its crack counts as straight.
#include "coarse/enrichment/tip_reach.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/cracked_mesh.hpp"

namespace stria::coarse {
namespace {

// The tip at the origin looks along x. Behind it the crack dips to -0.1 and then rises to 0.5.
CrackSection dipping_crack() {
    CrackSection crack;
    crack.points = {{-5.0, 0.5}, {-2.0, -0.1}, {-1.0, 0.0}, {0.0, 0.0}};
    return crack;
}

Tip tip_at_origin() {
    Tip tip;
    tip.crack = 0;
    tip.upper = 1;
    tip.position = {0.0, 0.0};
    tip.direction = {1.0, 0.0};
    return tip;
}

TEST(TipReach, EndsWhereTheCrackLeavesTheBandOnItsOtherSide) {
    // From -0.1 up to 0.2 is half of the way to 0.5.
    EXPECT_NEAR(straight_length(dipping_crack(), tip_at_origin(), 0.2), std::hypot(3.5, 0.2), 1e-12);
}

TEST(TipReach, DoesNotFeelAFurtherPointOfAStraightStretch) {
    CrackSection crack = dipping_crack();
    crack.points.insert(crack.points.begin() + 1, {-4.0, 0.3});
    EXPECT_NEAR(straight_length(crack, tip_at_origin(), 0.2), std::hypot(3.5, 0.2), 1e-12);
}

// The crack turns twice and comes back beside its tip: its faces there bound the rings, too.
TEST(TipReach, EndsAtAStretchOfTheSameCrackThatComesBack) {
    Mesh far_away;
    far_away.nodes = {{-100.0, -100.0}, {100.0, -100.0}};
    CrackSection hook;
    hook.points = {{6.0, -4.0}, {-8.0, -4.0}, {-8.0, 0.0}, {0.0, 0.0}};
    const Tip tip = tip_at_origin();
    EXPECT_NEAR(room_in_body(far_away, {hook}, tip, 0.2), 4.0, 1e-12);
    hook.points = {{-8.0, -9.0}, {-8.0, 0.0}, {0.0, 0.0}};
    EXPECT_NEAR(room_in_body(far_away, {hook}, tip, 0.2), std::hypot(8.0, 0.2), 1e-12);
}

TEST(TipReach, IsHalfOfTheWayToAnotherTipOrCrackAndNotToItsOwn) {
    CrackSection own;
    own.points = {{-5.0, 0.0}, {0.0, 0.0}};
    Tip other = tip_at_origin();
    other.position = {6.0, 0.0};
    const std::vector<Tip> tips{tip_at_origin(), other};
    constexpr double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(half_way_to_other_end(std::span(tips).first(1), 0), infinite);
    EXPECT_EQ(half_way_to_other_cracks({own}, tips, 0), infinite);
    CrackSection beside;  // nearest between its points
    beside.points = {{-9.0, 4.0}, {9.0, 4.0}};
    EXPECT_DOUBLE_EQ(half_way_to_other_end(tips, 0), 3.0);
    EXPECT_DOUBLE_EQ(half_way_to_other_cracks({own, beside}, tips, 0), 2.0);
}

TEST(TipReach, EndsAtTheBoundary) {
    const Mesh mesh = test::square_mesh(2, 8.0);
    EXPECT_DOUBLE_EQ(distance_to_boundary(mesh, {3.0, 5.5}), 2.5);  // from the middle of an edge
    EXPECT_DOUBLE_EQ(distance_to_boundary(mesh, {1.0, 5.5}), 1.0);
    Tip tip = tip_at_origin();
    tip.position = {3.0, 5.5};
    EXPECT_DOUBLE_EQ(room_in_body(mesh, {}, tip, 0.2), 2.5);
}

// Of the columns of a square the last one is of another metal.
TEST(TipReach, OfTheTipsMetalEndsAtTheNextOne) {
    Case input;
    input.material = {.young = 200e3, .poisson = 0.3, .yield_stress = {}, .isotropic = {}, .kinematic = {}};
    input.regions.resize(1);
    input.regions[0].material = input.material;
    Mesh square = test::square_mesh(4, 8.0);
    square.material.assign(16, 0);
    for (const int row : {0, 1, 2, 3}) square.material[at(4 * row + 3)] = 1;
    const EnrichedMesh mesh = test::cracked(square, {{0.0, 4.4}, {3.5, 4.4}}, 1);
    EXPECT_EQ(distance_to_interface(mesh, Materials(input), mesh.tips[0]), std::numeric_limits<double>::infinity());
    input.regions[0].material.young = 70e3;
    EXPECT_DOUBLE_EQ(distance_to_interface(mesh, Materials(input), mesh.tips[0]), 2.5);
}

// 3 by 4 mm.
TEST(TipReach, IsMeasuredInTheElementOfTheTip) {
    const Mesh plate = grid_mesh(test::equal_cells(4, 12.0), test::equal_cells(4, 16.0));
    const EnrichedMesh mesh = test::cracked(plate, {{0.0, 6.0}, {4.0, 6.0}}, 1);
    EXPECT_DOUBLE_EQ(tip_element_size(mesh, mesh.tips[0]), 5.0);
    EXPECT_DOUBLE_EQ(tip_element_edge(mesh, mesh.tips[0]), 5.0 / std::sqrt(2.0));
    Tip other = mesh.tips[0];
    other.crack = 1;
    EXPECT_EQ(tip_element_size(mesh, other), 0.0);
}

// Of a square with a tip in its middle. That of an edge behind, and of a corner straight ahead, is told from others.
TEST(TipReach, MeetsTheBoundaryAhead) {
    const Mesh mesh = test::square_mesh(4);
    Tip tip = tip_at_origin();
    tip.position = {0.4, 0.5};
    EXPECT_NEAR(way_to_boundary(mesh, tip), 0.6, 1e-12);
    tip.direction = {-0.6, 0.8};
    EXPECT_NEAR(way_to_boundary(mesh, tip), 0.625, 1e-12);
    tip.position = {0.5, 0.5};
    tip.direction = Vec2(1.0, 1.0).normalized();
    EXPECT_NEAR(way_to_boundary(mesh, tip), std::sqrt(0.5), 1e-12);
}

}  // namespace
}  // namespace stria::coarse
