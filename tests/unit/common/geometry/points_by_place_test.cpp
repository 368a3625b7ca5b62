#include "common/geometry/points_by_place.hpp"

#include <gtest/gtest.h>

#include "common/index.hpp"

namespace stria {
namespace {

// On a grid, where cells have their borders at the worst places, with some points closer than others.
TEST(PointsByPlace, FindsEachPointAndNothingElse) {
    std::vector<Vec2> points;
    for (int i = -7; i < 12; ++i)
        for (int j = -3; j < 30; ++j) points.emplace_back(0.1 * i, 0.3 * j);
    for (const double neighbours : {0.1, 0.2, 0.3}) {
        const PointsByPlace by_place(points, neighbours);
        const Vec2 near(3e-7 * neighbours, -6e-7 * neighbours), off(3e-7 * neighbours, -11e-7 * neighbours);
        for (int p = 0; p < std::ssize(points); ++p) {
            EXPECT_EQ(by_place.at_place(points[at(p)]), p);
            EXPECT_EQ(by_place.at_place(points[at(p)] + near), p);
            EXPECT_EQ(by_place.at_place(points[at(p)] - near), p);
            EXPECT_EQ(by_place.at_place(points[at(p)] + off), -1);
        }
        EXPECT_EQ(by_place.at_place({1000.0, -1000.0}), -1);
    }
    EXPECT_EQ(PointsByPlace({}, 1.0).at_place({0.0, 0.0}), -1);
}

}  // namespace
}  // namespace stria
