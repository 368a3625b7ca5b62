// Where segments meet: exact in whether they do, and on both of them where they nearly lie on one line.
#include "common/geometry/clipping.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "common/geometry/segment.hpp"

namespace stria {
namespace {

// A chord of an arc and the edges of a mesh whose nodes lie on it, to rounding: some cross it, others do not.
TEST(Intersection, LiesOnBothSegmentsWhereTheyAreNearlyOneLine) {
    constexpr double angle = 5.0 * std::numbers::pi / 180.0;
    const Vec2 from(0.0, 1.0), to(0.6 * std::sin(angle), 1.6 - 0.6 * std::cos(angle));
    int met = 0;
    for (int cells = 2; cells < 60; ++cells) {
        const auto node = [&](int k) {
            const double x = to.x() * k / cells;
            return Vec2(x, from.y() + x / to.x() * (to.y() - from.y()));
        };
        for (int k = 0; k < cells; ++k) {
            const auto common = intersect(from, to, node(k), node(k + 1));
            if (!common) continue;
            ++met;
            for (const Vec2& x : {common->first, common->second}) {
                EXPECT_LT(distance_to_segment(x, node(k), node(k + 1)), 1e-12) << cells << " " << k;
                EXPECT_LT(distance_to_segment(x, from, to), 1e-12) << cells << " " << k;
            }
        }
    }
    EXPECT_GT(met, 100);
}

}  // namespace
}  // namespace stria
