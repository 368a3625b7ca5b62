// The displacement of a mesh at places of another one, on either side of a crack.
#include "common/integration/element_field.hpp"

#include <gtest/gtest.h>

#include "tests/support/cracked_mesh.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

const Field upper_field = [](const Vec2& x) { return Vec2(0.1 * x.x() + 0.3, 0.2 * x.y() - 0.1 * x.x() + 0.5); };
const Field lower_field = [](const Vec2& x) { return Vec2(-0.2 * x.y(), 0.3 * x.x() - 0.4); };

Term jump_on(double side) { return {.kind = Term::Kind::Heaviside, .owner = 0, .function = 0, .shift = side}; }

/// 3 x 4 unit elements that a crack parts at the height y.
struct Parted {
    explicit Parted(double y)
        : mesh(plate_mesh(3, 4, plate_case({{0.0, y}, {3.0, y}}))),
          u(two_sided(mesh, {0.0, y}, {3.0, y}, upper_field, lower_field)) {}
    [[nodiscard]] ElementField element(int column, int row) const {
        const int e = 3 * row + column;
        return {mesh, e, piece_in(mesh, e)};
    }
    [[nodiscard]] Vec2 value(const Shares& shares) const { return sum_of(shares, u); }

    EnrichedMesh mesh;
    Eigen::VectorXd u;
};

void expect_alike(const Vec2& found, const Vec2& expected) { EXPECT_LT((found - expected).norm(), 1e-14); }

TEST(ElementField, ContinuesEitherSideOverTheWholeElement) {
    const Parted plate(1.6);
    const ElementField cut = plate.element(1, 1);
    ASSERT_TRUE(cut.is_cut());
    EXPECT_EQ(cut.own_side(), 0);
    for (const Vec2& x : {Vec2(1.2, 1.3), Vec2(1.9, 1.9), Vec2(1.0, 1.0)}) {
        expect_alike(plate.value(cut.on_side(x, 1)), upper_field(x));
        expect_alike(plate.value(cut.on_side(x, -1)), lower_field(x));
    }
}

TEST(ElementField, KnowsTheSideOfPlacesOnItsBoundary) {
    const Parted plate(1.6);
    const ElementField cut = plate.element(1, 1);
    for (const double x : {1.0, 1.5, 2.0}) {
        EXPECT_EQ(cut.side_of({x, 2.0}), 1);
        EXPECT_EQ(cut.side_of({x, 1.0}), -1);
    }
    for (const double x : {1.0, 2.0}) {
        EXPECT_EQ(cut.side_of({x, 1.61}), 1);
        EXPECT_EQ(cut.side_of({x, 1.59}), -1);
    }
}

TEST(ElementField, OfElementsAlongACrackIsThatOfTheirSide) {
    const Parted plate(2.0);
    const ElementField upper = plate.element(1, 2), lower = plate.element(1, 1);
    EXPECT_EQ(upper.own_side(), 1);
    EXPECT_EQ(lower.own_side(), -1);
    expect_alike(plate.value(upper.on_side({1.3, 2.0}, 1)), upper_field({1.3, 2.0}));
    expect_alike(plate.value(lower.on_side({1.3, 2.0}, -1)), lower_field({1.3, 2.0}));
}

// A node that hangs in the middle of an edge and does not jump yet has the displacement of where it lies.
TEST(FieldAtNode, WithoutAJumpIsThatOfItsPlace) {
    const Parted plate(1.6);
    for (const double y : {1.2, 1.8}) {
        const Vec2 x(1.0, y);
        FieldAtNode node(x, {});
        node.add(plate.element(0, 1));
        ASSERT_TRUE(node.standard());
        expect_alike(plate.value(*node.standard()), y > 1.6 ? upper_field(x) : lower_field(x));
        ASSERT_TRUE(node.half_jump());
        expect_alike(plate.value(*node.half_jump()), 0.5 * (upper_field(x) - lower_field(x)));
    }
}

// Whichever side its place is on now.
TEST(FieldAtNode, WithAJumpIsThatOfItsOwnSide) {
    const Parted plate(1.6);
    const Vec2 x(1.0, 1.8);
    for (const double side : {1.0, -1.0}) {
        FieldAtNode node(x, {jump_on(side)});
        node.add(plate.element(0, 1));
        ASSERT_TRUE(node.standard());
        expect_alike(plate.value(*node.standard()), side > 0.0 ? upper_field(x) : lower_field(x));
        node.add(plate.element(0, 2));  // not cut, and above
        expect_alike(plate.value(*node.standard()), side > 0.0 ? upper_field(x) : lower_field(x));
    }
}

TEST(FieldAtNode, OnACrackAlongEdgesIsToldFromBothSides) {
    const Parted plate(2.0);
    const Vec2 x(1.5, 2.0);
    for (const double side : {1.0, -1.0}) {
        FieldAtNode node(x, {jump_on(side)});
        EXPECT_FALSE(node.standard());
        node.add(plate.element(1, 2));
        EXPECT_FALSE(node.half_jump()) << "one side alone";
        node.add(plate.element(1, 1));
        ASSERT_TRUE(node.standard());
        expect_alike(plate.value(*node.standard()), side > 0.0 ? upper_field(x) : lower_field(x));
        expect_alike(plate.value(node.half_jump().value()), 0.5 * (upper_field(x) - lower_field(x)));
    }
    FieldAtNode plain(x, {});
    plain.add(plate.element(1, 2));
    ASSERT_TRUE(plain.standard());
    expect_alike(plate.value(*plain.standard()), upper_field(x));
}

}  // namespace
}  // namespace stria::test
