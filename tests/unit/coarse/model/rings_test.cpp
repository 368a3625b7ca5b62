// Which rings there are about a tip, and which of them the zone hears of.
#include "coarse/model/rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/structure/structure.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/fracture/ring_weights.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

Scene cracked_plate(double size, bool contact) { return refined_scene(test::pulled_plate(size, true, contact)); }

TEST(Rings, LieInTheLargestAndAreTwoElementsThick) {
    const Scene scene = cracked_plate(0.25, false);
    const double radius = largest_ring(scene, 0);
    EXPECT_NEAR(radius, 0.95 * 7.3, 1e-12);
    const std::vector<Annulus> rings = rings_about(scene, 0);
    EXPECT_EQ(rings.size(), 5U);
    for (const Annulus& ring : rings) {
        EXPECT_LE(ring.outer, radius);
        EXPECT_GE(ring.outer - ring.inner, 2.0 * 0.25);
        EXPECT_LE(ring.outer - ring.inner, rings.front().outer - rings.front().inner);
    }
}

// With the body's elements they would become more and more, in each growth again. Where all is solved once K converges.
TEST(Rings, AreNoLongerThanFortyElementsOfABodyWhoseCrackGrows) {
    const double size = 0.125;
    Case input = test::pulled_plate(size, false, false);
    EXPECT_NEAR(largest_ring(refined_scene(input), 0), 0.95 * 7.3, 1e-12);
    input.growth = GrowthSection{.increment = 0.25};
    const Scene scene = refined_scene(input);
    double longest = 0.0;
    for (const auto& element : scene.mesh->elements)
        for (std::size_t k = 0; k < 4; ++k)
            longest = std::max(
                longest, (scene.mesh->nodes[at(element[k])] - scene.mesh->nodes[at(element[(k + 1) % 4])]).norm());
    EXPECT_LT(40.0 * longest, 0.8 * 7.3);
    EXPECT_NEAR(largest_ring(scene, 0), 40.0 * longest, 1e-12);
    EXPECT_NEAR(largest_ring(cracked_plate(size, false), 0), 0.95 * 7.3,
                1e-12);  // where flow goes how far nobody knows
}

// By four tenths of the way to a point, whatever acts there, and by a twentieth of that to a loaded edge.
TEST(Rings, StayOffPointsThatBearAForceOrAreHeld) {
    const Case plate = test::pulled_plate(0.25, true, false);
    const Vec2 near(7.25, 15.25), far(7.25, 2.0);
    const auto largest_with = [&](const std::function<void(BoundarySection&, double)>& act) {
        Case input = plate;
        for (const Vec2& place : {near, far}) {
            BoundarySection& point = input.boundaries.emplace_back();
            point.on = "point";
            point.at = place;
            act(point, place == near ? 1.0 : -1.0);
        }
        return largest_ring(refined_scene(input), 0);
    };
    const double radius = 0.6 * (near - Vec2(7.3, 10.4)).norm();
    EXPECT_NEAR(largest_with([](auto& point, double sign) { point.force = Vec2(0.0, sign); }), radius, 1e-12);
    EXPECT_NEAR(largest_with([](auto& point, double) { point.displacement[0] = 0.0; }), radius, 1e-12);
}

// What flows about the other end of a crack stays outside.
TEST(Rings, ReachBeyondTheMiddleOfAnElasticCrackOfFewElements) {
    Case input = test::pulled_plate(1.0, false, false);
    const auto of_length = [&](double length) {
        input.cracks[0].points = {{8.2, 15.1}, {8.2 + length, 15.1}};
        return largest_ring(refined_scene(input), 0);
    };
    EXPECT_NEAR(of_length(3.0), 0.8 * 3.0, 1e-12);
    EXPECT_NEAR(of_length(6.0), 4.0, 1e-12) << "as many elements";
    EXPECT_NEAR(of_length(9.0), 0.475 * 9.0, 1e-12);
    input.cracks.push_back({.points = {{0.0, 15.1}, {5.2, 15.1}}, .contact = {}});
    EXPECT_NEAR(of_length(3.5), 0.475 * 3.0, 1e-12);
    input.cracks.pop_back();
    input.material.yield_stress = 300.0;
    EXPECT_NEAR(of_length(3.0), 0.475 * 3.0, 1e-12);
}

// Up to the bend no corner of an element lay in a ring: there was nothing to sum up, and K was not a number.
TEST(Rings, PassOverABendThatIsNearerThanTwoElements) {
    for (const double behind : {0.02, 0.1, 0.3, 0.7, 1.5, 3.0}) {
        Case input = test::pulled_plate(1.0, false, false);
        input.cracks[0].points = {{0.0, 10.4}, {5.45, 10.4}, {5.45, 10.4 + behind}};
        const Scene scene = refined_scene(input);
        EXPECT_GE(largest_ring(scene, 0), 0.95 * std::max(2.0, behind)) << behind;
        for (const Annulus& ring : rings_about(scene, 0))
            EXPECT_TRUE(reaches(scene.enriched, scene.enriched.tips[0], ring)) << behind;
    }
}

// J is quadratic in the singular field of a bend's corner, which elements about it do not hold: a ring that comes near
// had it 20 % off four elements behind a bend, and ten times off nearer. K, of first order, is from the larger rings.
TEST(Rings, ForJEndTwoElementsBeforeASharpBend) {
    const auto bent = [](double length, double degrees) {
        Case input = test::pulled_plate(0.5, false, false);
        const double angle = degrees * std::numbers::pi / 180.0;
        input.cracks[0].points = {
            {0.0, 10.4}, {5.3, 10.4}, Vec2(5.3, 10.4) + length * Vec2(std::cos(angle), std::sin(angle))};
        return refined_scene(input);
    };
    for (const double degrees : {90.0, -60.0, 11.0}) {
        const Scene scene = bent(3.0, degrees);
        const std::vector<Annulus> rings = rings_about(scene, 0);
        EXPECT_NEAR(rings.front().outer, 3.0 - 2.0 * 0.5, 1e-9) << degrees;
        EXPECT_TRUE(rings.front().tells_J && !rings.front().tells_K) << degrees;
        EXPECT_EQ(first_for_K(rings), 1U) << degrees;
        EXPECT_GE(rings[1].outer, 0.95 * 3.0) << degrees;
        EXPECT_EQ(std::ranges::count(rings, false, &Annulus::tells_J),
                  std::ranges::count_if(rings, [&](auto& ring) { return ring.outer > rings.front().outer; }))
            << degrees;
        EXPECT_TRUE(bends_leave_J(scene, 0));
        const Scene nearer = bent(1.9, degrees);
        EXPECT_FALSE(bends_leave_J(nearer, 0));
        EXPECT_TRUE(std::ranges::none_of(rings_about(nearer, 0), &Annulus::tells_J)) << degrees;
    }
    const Scene slight = bent(1.0, 9.0);
    EXPECT_TRUE(rings_about(slight, 0).front().tells_J && rings_about(slight, 0).front().tells_K);
}

TEST(Rings, AreFewerOnACoarseMeshButNeverNone) {
    EXPECT_LT(rings_about(cracked_plate(1.0, false), 0).size(), 5U);
    EXPECT_EQ(rings_about(cracked_plate(2.0, false), 0).size(), 1U);
}

TEST(Rings, GoToTheZoneOnlyIfItHasAShareInThem) {
    for (const bool contact : {false, true}) {
        const Scene scene = cracked_plate(0.25, contact);
        const Structure structure(scene, select_zone(scene, {0.0}));
        const coupling::Patch patch =
            make_patch(scene, structure.in_zone(), structure.gamma(), Eigen::VectorXd::Zero(scene.enriched.unknowns));
        EXPECT_EQ(patch.rings.size(), contact ? 5U : 0U);  // the faces of a crack that may touch are all in the zone
    }
}

// K from the first ring beyond what has flowed, its spread over such rings; J and its spread from all.
TEST(Rings, ThatHoldFlowDoNotTellK) {
    const Scene scene = cracked_plate(0.25, false);
    const Structure structure(scene);
    const Eigen::VectorXd u = structure.expand({}, 1.0);
    const double radius = largest_ring(scene, 0);
    const auto parameters = [&](double reach, double begin = 0.0) {
        coupling::StepReport report;
        report.tips = {{.flow_ever = {{.begin = begin * radius, .end = reach * radius, .reach = reach * radius}}}};
        report.contact_length = report.mouth_opening = {0.0};
        return fracture_parameters(structure, u, report).front();
    };
    const TipResult elastic = parameters(0.0), near = parameters(0.4), far = parameters(0.6), all = parameters(0.9);
    for (const TipResult& tip : {near, far, all}) {
        EXPECT_EQ(tip.J, elastic.J);
        EXPECT_EQ(tip.J_spread, elastic.J_spread);
    }
    EXPECT_EQ(near.K_I, elastic.K_I);
    EXPECT_LE(near.K_spread, elastic.K_spread);
    EXPECT_NE(far.K_I, elastic.K_I);  // of the ring that begins at 3/4
    EXPECT_NEAR(far.K_I, elastic.K_I, 0.01 * elastic.K_I);
    EXPECT_TRUE(std::isnan(far.K_spread));
    EXPECT_FALSE(far.rings_flow);
    EXPECT_TRUE(all.rings_flow);
    EXPECT_EQ(all.K_I, far.K_I);
    const TipResult elsewhere = parameters(2.0, 1.1);  // under a load, say
    EXPECT_FALSE(elsewhere.rings_flow);
    EXPECT_EQ(elsewhere.K_I, elastic.K_I);
    EXPECT_EQ(elsewhere.K_spread, elastic.K_spread);
}

TEST(Rings, WeightFallsFromOneToNothing) {
    const Annulus ring{1.0, 3.0};
    EXPECT_EQ(ring.weight(0.5), 1.0);
    EXPECT_EQ(ring.weight(1.5), 0.75);
    EXPECT_EQ(ring.weight(4.0), 0.0);
}

}  // namespace
}  // namespace stria::coarse
