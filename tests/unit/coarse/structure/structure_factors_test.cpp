// What one structure leaves to the next: far elements that stay far, and factors that serve again to the last bit.
#include <gtest/gtest.h>

#include <algorithm>

#include "coarse/structure/structure.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

/// A wide plate whose crack grows; contact and a disk of 1.5 mm make the zone.
Scene scene_with(double crack) {
    Case input = test::pulled_plate(0.5, true, true);
    input.mesh.width = input.mesh.height = 40.0;
    input.cracks[0].points = {{0.0, 20.2}, {crack, 20.2}};
    input.fine.radius = 1.5;
    input.load.blocks = {{.cycles = 20, .max = 50.0, .min = 0.0}};
    input.growth = GrowthSection{.increment = 0.5};
    return refined_scene(input);
}

class Factors : public testing::Test {
protected:
    static ElementSet zone_of(const Scene& scene) { return select_zone(scene, {0.0}); }

    const Scene scene = scene_with(7.3), longer = scene_with(7.8), far_on = scene_with(13.3);
    const ElementSet zone = zone_of(scene), next_zone = zone_of(longer);
    const ElementSet far = far_elements(scene, zone);
};

TEST_F(Factors, FarElementsStayUntilOneHasToBeNear) {
    EXPECT_GT(far.count(), far.size() / 4);
    EXPECT_EQ(far_elements(longer, next_zone, far), far);
    const ElementSet zone_far_on = zone_of(far_on), anew = far_elements(far_on, zone_far_on, far);
    EXPECT_NE(anew, far);
    EXPECT_EQ(anew, far_elements(far_on, zone_far_on));
    const ElementSet near = near_elements(far_on, zone_far_on);
    for (const int e : anew.members()) EXPECT_FALSE(near.contains(e) || zone_far_on.contains(e));
}

TEST_F(Factors, OfAFarBodyServeAgainToTheLastBit) {
    const Structure before(scene, zone, far), fresh(longer, next_zone, far),
        again(longer, next_zone, far, before.factors());
    EXPECT_EQ(again.factors().far, before.factors().far);
    EXPECT_NE(fresh.factors().far, before.factors().far);
    EXPECT_EQ(again.tangent(), fresh.tangent());
    EXPECT_EQ(again.loads().unit().boundary, fresh.loads().unit().boundary);
    EXPECT_EQ(again.loads().mean_displacement().weights, fresh.loads().mean_displacement().weights);
    EXPECT_EQ(again.loads().mean_displacement().per_load_factor, fresh.loads().mean_displacement().per_load_factor);
    const Eigen::VectorXd gamma = Eigen::VectorXd::LinSpaced(std::ssize(fresh.gamma()), -1e-3, 1e-3);
    EXPECT_EQ(again.expand(gamma, 40.0), fresh.expand(gamma, 40.0));
}

TEST_F(Factors, OfTheSameMatrixServeAgain) {
    const Structure before(scene, zone, far), again(scene, zone, far, before.factors()),
        other(longer, next_zone, far, before.factors());
    EXPECT_EQ(again.factors().near, before.factors().near);
    EXPECT_NE(other.factors().near, before.factors().near);
}

TEST_F(Factors, DoNotDependOnWhatIsFar) {
    const Structure some(scene, zone, far), none(scene, zone, ElementSet(far.size()));
    EXPECT_EQ(none.factors().far, nullptr);
    EXPECT_EQ(some.gamma(), none.gamma());
    EXPECT_LT((some.tangent() - none.tangent()).norm(), 1e-12 * none.tangent().norm());
    const Eigen::VectorXd gamma = Eigen::VectorXd::Zero(std::ssize(none.gamma())), u = none.expand(gamma, 1.0);
    EXPECT_LT((some.expand(gamma, 1.0) - u).norm(), 1e-11 * u.norm());
    EXPECT_NEAR(some.loads().mean_displacement().per_load_factor, scene.mean_displacement.dot(u), 1e-11 * u.norm());
}

}  // namespace
}  // namespace stria::coarse
