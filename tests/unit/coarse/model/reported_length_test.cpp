#include "coarse/model/reported_length.hpp"

#include <gtest/gtest.h>

#include "coarse/zone/refined_scene.hpp"
#include "common/error.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::coarse {
namespace {

/// A plate 24 mm wide whose crack, of one or two tips, is 8 mm long.
Scene plate(bool inner, double until) {
    Case input = test::sent_case({"mesh.width=24.0", "mesh.size=2.0", "mesh.grading=[]", "fine.refine=1"});
    const double y = 0.5 * input.mesh.height + 0.2;
    input.cracks.front().points =
        inner ? std::vector<Vec2>{{8.0, y}, {16.0, y}} : std::vector<Vec2>{{0.0, y}, {8.0, y}};
    input.growth = GrowthSection{.increment = 0.5, .until = until};
    return refined_scene(input);
}

TEST(ReportedLength, IsHalfOfACrackWithTwoTips) {
    const Scene edge = plate(false, 9.0), inner = plate(true, 9.0);
    EXPECT_NEAR(reported_length(edge, edge.enriched.tips[0]), 8.0, 1e-12);
    for (const Tip& tip : inner.enriched.tips) EXPECT_NEAR(reported_length(inner, tip), 4.0, 1e-12);
}

// Around a bend, and whatever the other tip does meanwhile.
TEST(ReportedLength, TheWayOfATipIsItsOwn) {
    Scene scene = plate(true, 9.0);
    const Vec2 start = scene.input.cracks[0].points.front(), end = scene.input.cracks[0].points.back();
    std::vector<double> before, after;
    for (const Tip& tip : scene.enriched.tips) before.push_back(way_to_tip(scene, tip));
    CrackSection& crack = scene.input.cracks[0];
    crack.points = {start + Vec2(-0.3, -0.4), start, end, end + Vec2(0.0, 0.6), end + Vec2(0.8, 1.2)};
    crack.grown_at_start = 0.5;
    scene.enriched.tips[0].position = crack.points.front();
    scene.enriched.tips[1].position = crack.points.back() + Vec2(0.008, 0.006);  // put onto a node
    for (const Tip& tip : scene.enriched.tips) after.push_back(way_to_tip(scene, tip));
    EXPECT_NEAR(after[0] - before[0], 0.5, 1e-12);
    EXPECT_NEAR(after[1] - before[1], 0.6 + 1.0 + 0.01, 1e-12);
}

TEST(ReportedLength, LeavesAWayToGrow) {
    EXPECT_NO_THROW(require_way_to_grow(plate(false, 8.01)));
    EXPECT_THROW(require_way_to_grow(plate(false, 8.0)), CaseError);
    EXPECT_THROW(require_way_to_grow(plate(false, 5.0)), CaseError);
    EXPECT_NO_THROW(require_way_to_grow(plate(true, 4.01)));
    EXPECT_THROW(require_way_to_grow(plate(true, 4.0)), CaseError);
}

}  // namespace
}  // namespace stria::coarse
