// Which points of a polyline shape it.
#include "common/crack/bends.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria::test {
namespace {

using Polyline = std::vector<Vec2>;

TEST(Bends, ArePointsWhereAPolylineTurns) {
    const Vec2 mouth(0.0, 9.9731), bend(4.23352, 8.6214), tip(5.73352, 8.97002);
    const auto between = [](const Vec2& a, const Vec2& b, double t) { return Vec2(a + t * (b - a)); };
    const Polyline shape{mouth, bend, tip};
    EXPECT_EQ(ends_and_bends(shape), shape);
    EXPECT_EQ(ends_and_bends({mouth, tip}), (Polyline{mouth, tip}));
    for (double t = 0.01; t < 0.99; t += 0.0371) {
        const Polyline pointed{mouth, between(mouth, bend, t), between(mouth, bend, t + 0.005),
                               bend,  between(bend, tip, t),   tip};
        EXPECT_EQ(ends_and_bends(pointed), shape) << t;
    }
}

TEST(Bends, MayBeSlight) {
    const Polyline slight{{0.0, 0.0}, {1.0, 0.0}, {2.0, 1e-8}};
    EXPECT_EQ(ends_and_bends(slight), slight);
}

// Between two points a long way need not tell where a short one leads.
TEST(Bends, MayLieNearAnEnd) {
    const Polyline bent{{0.0, 0.0}, {1e3, 0.0}, {1e3, 1e-7}};
    EXPECT_EQ(ends_and_bends(bent), bent);
}

// They are refused, by who says where.
TEST(Bends, AreWhereAPolylineTurnsBackOrRepeatsAPoint) {
    const Polyline back{{0.0, 0.0}, {1.0, 0.0}, {0.5, 0.0}}, twice{{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}};
    EXPECT_EQ(ends_and_bends(back), back);
    EXPECT_EQ(ends_and_bends(twice), twice);
}

// An arc of many short stretches stays one: each bend is told from the last point that was kept.
TEST(Bends, OfAnArcAddUp) {
    constexpr double radius = 10.0, angle = 1e-10;
    Polyline arc;
    for (int k = 0; k < 1000; ++k) arc.push_back(radius * Vec2(std::sin(angle * k), 1.0 - std::cos(angle * k)));
    EXPECT_GT(ends_and_bends(arc).size(), 2U);
}

}  // namespace
}  // namespace stria::test
