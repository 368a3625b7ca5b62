// What a tip has left behind, seen from later meshes.
#include "fine/growth/frozen_tips.hpp"

#include <gtest/gtest.h>

#include "common/crack/crack_crossings.hpp"
#include "common/integration/crack_faces.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/refined_squares.hpp"

namespace stria::fine {
namespace {

// Where smaller elements do not pull the mouth onto a node the crack runs beside the one that was left, by parts of a
// thousandth of an element.
TEST(FrozenTips, KeepTheirJumpWhereAFinerMeshHoldsTheCrackElsewhere) {
    const Mesh body = test::square_mesh(4),
               finer = test::refined(body, {{{0.0, 0.25}, {0.0, 0.25}, 0.01, 1, 0.0}}).mesh;
    const Vec2 mouth(0.0, 0.25 + 0.6 * snap_fraction * 0.25);
    const EnrichedMesh before = test::cracked(body, {mouth, {0.85, 0.4}}, 1),
                       after = test::cracked(finer, {mouth, {0.85, 0.4}}, 1);
    FrozenTips frozen;
    frozen.freeze(before, 0, Eigen::VectorXd::Ones(before.unknowns));
    const double tip = before.tips[0].s;
    for (const double behind : {0.02, 0.06, 0.13}) {
        const Vec2 old_place = face_station_at(before, 0, tip - behind).x,
                   new_place = face_station_at(after, 0, tip - behind).x;
        ASSERT_GT((new_place - old_place).norm(), 1e-7);
        const Vec2 jump = frozen.jump(0, old_place);
        EXPECT_GT(jump.norm(), 0.01) << behind;
        EXPECT_LT((frozen.jump(0, new_place) - jump).norm(), 1e-3 * jump.norm()) << behind;
    }
    EXPECT_EQ(frozen.jump(0, before.tips[0].position + Vec2(0.001, 0.0)), Vec2(0.0, 0.0));
}

}  // namespace
}  // namespace stria::fine
