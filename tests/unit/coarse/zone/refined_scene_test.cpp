// Meshes refined about the tips: how small, how far, and along the planned growth.
#include "coarse/zone/refined_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coarse/specimen/specimen.hpp"
#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/index.hpp"
#include "tests/support/pulled_plate.hpp"
#include "tests/support/refusal.hpp"

namespace stria::coarse {
namespace {

/// Of unit elements, pulled in four cycles up to `traction`, MPa.
Case plate(int refine, double traction = 10.0) {
    Case input = test::pulled_plate(1.0, true, false);
    input.fine.refine = refine;
    input.load.blocks = {{.cycles = 4, .max = traction, .min = 0.0}};
    return input;
}

/// Edge of the element at a place, mm.
double size_at(const Scene& scene, const Vec2& place) {
    double size = std::nan(""), nearest = INFINITY;
    for (int e = 0; e < std::ssize(scene.mesh->elements); ++e) {
        const double distance = (centre(scene.enriched, e) - place).norm();
        if (distance >= nearest) continue;
        nearest = distance;
        const auto& nodes = scene.mesh->elements[at(e)];
        size = (scene.mesh->nodes[at(nodes[1])] - scene.mesh->nodes[at(nodes[0])]).norm();
    }
    return size;
}

TEST(RefinedScene, IsThatOfTheSpecimensMeshWithoutRefinement) {
    const Case input = plate(1);
    const Scene scene = refined_scene(input);
    EXPECT_EQ(scene.mesh->nodes.size(), make_mesh(input.mesh, input.cracks).nodes.size());
    EXPECT_TRUE(scene.enriched.tied.empty());
}

TEST(RefinedScene, HasElementsAsSmallAsAskedForAboutTheTip) {
    const Scene scene = refined_scene(plate(4));
    const Tip& tip = scene.enriched.tips.at(0);
    EXPECT_NEAR(size_at(scene, tip.position), 0.25, 1e-12);
    EXPECT_NEAR(size_at(scene, {19.5, 0.5}), 1.0, 1e-12);
}

TEST(RefinedScene, RefinesAsFarAsTheRadiusSays) {
    Case input = plate(2);
    input.fine.radius = 4.0;
    const Scene scene = refined_scene(input);
    const Vec2 tip = scene.enriched.tips.at(0).position;
    EXPECT_NEAR(size_at(scene, tip + Vec2(3.5, 0.0)), 0.5, 1e-12);
    EXPECT_NEAR(size_at(scene, tip + Vec2(8.0, 0.0)), 1.0, 1e-12);
}

TEST(RefinedScene, TakesItsRadiusFromTheLoadHistory) {
    const auto elements_at = [](double traction) {
        Case input = plate(2, traction);
        input.fine.beta = 8.0;  // at the larger load a radius beyond the few elements that there are in any case
        return refined_scene(input).mesh->elements.size();
    };
    EXPECT_GT(elements_at(70.0), elements_at(10.0));
}

TEST(RefinedScene, HasRoomToGrowWhateverTheLengthOfTheRun) {
    Case input = plate(2);
    input.fine.radius = 4.0;
    const Vec2 tip = refined_scene(input).enriched.tips.at(0).position, ahead = tip + Vec2(5.2, 0.0);
    EXPECT_NEAR(size_at(refined_scene(input), ahead), 1.0, 1e-12);
    input.growth = GrowthSection{.increment = 1.25};
    const Scene room = refined_scene(input);
    EXPECT_NEAR(size_at(room, ahead), 0.5, 1e-12);
    input.load.blocks[0].cycles *= 100;
    EXPECT_EQ(refined_scene(input).mesh->elements, room.mesh->elements);
}

// What flows there before the tip has turned is never split. It turns by about 45 degrees.
TEST(RefinedScene, HasSmallElementsWhereACrackIsAboutToTurn) {
    Case input = plate(8, 80.0);
    input.fine.radius = 2.0;
    input.fine.growth = 0.29;
    const Vec2 tip(8.4, 8.2);
    input.cracks[0].points = {{0.0, 10.3}, {6.3, 10.3}, tip};
    input.growth = GrowthSection{.increment = 0.25};
    const Vec2 turned = tip + Vec2(1.8, 0.0);
    const auto size_there = [&](const Vec2& place) { return size_at(refined_scene(input), place); };
    EXPECT_NEAR(size_there(turned), 0.125, 1e-12);
    input.growth->direction = GrowthDirection::Straight;
    EXPECT_NEAR(size_there(turned), 0.25, 1e-12);
}

TEST(RefinedScene, SaysWhichBodyItSolvesBeforeItDoes) {
    const auto elements_heard_of = [](const Case& input) {
        std::vector<std::size_t> elements;
        static_cast<void>(
            refined_scene(input, [&](const Scene& scene) { elements.push_back(scene.mesh->elements.size()); }));
        return elements;
    };
    Case input = plate(2);
    EXPECT_EQ(elements_heard_of(input), std::vector{make_mesh(input.mesh, input.cracks).elements.size()});
    input.load.control = Control::StressIntensity;
    for (BoundarySection& boundary : input.boundaries) *boundary.traction *= -1.0;
    int heard = 0;  // though the body has no tip with K_I > 0, as shows once it is solved
    EXPECT_THROW(static_cast<void>(refined_scene(input, [&](const Scene&) { ++heard; })), CaseError);
    EXPECT_EQ(heard, 1);
    input.fine.radius = 4.0;
    EXPECT_TRUE(elements_heard_of(input).empty());
    EXPECT_TRUE(elements_heard_of(plate(1)).empty());
}

TEST(RefinedScene, RefusesACrackShorterThanTheElementAtItsTip) {
    Case input = plate(2);
    input.cracks[0].points.back() = {0.4, 10.4};
    EXPECT_THROW(static_cast<void>(refined_scene(input)), CaseError);
}

// Such a point was one more corner of the parts of a cut element, and a bend in a row of element edges.
TEST(RefinedScene, IsTheSameToTheBitWithAPointOnAStraightStretchOfACrack) {
    using Polyline = std::vector<Vec2>;
    const Vec2 bend(5.3, 10.4), tip(7.9, 11.3);
    const auto scene_of = [](const Polyline& points) {
        Case input = plate(2);
        input.cracks[0].points = points;
        return refined_scene(input);
    };
    for (const auto& [shape, pointed] :
         {std::pair(Polyline{{0.0, 10.4}, bend, tip},
                    Polyline{{0.0, 10.4}, {2.7, 10.4}, bend, bend + 0.9 * (tip - bend), tip}),
          std::pair(Polyline{{0.0, 10.0}, {7.3, 10.0}}, Polyline{{0.0, 10.0}, {2.7, 10.0}, {7.3, 10.0}})}) {
        const Scene scene = scene_of(shape), other = scene_of(pointed);
        EXPECT_EQ(other.input, scene.input);
        EXPECT_EQ(other.mesh->nodes, scene.mesh->nodes);
        ASSERT_EQ(other.enriched.pieces.size(), scene.enriched.pieces.size());
        for (std::size_t k = 0; k < scene.enriched.pieces.size(); ++k) {
            EXPECT_EQ(other.enriched.pieces[k].points, scene.enriched.pieces[k].points) << "piece " << k;
            EXPECT_EQ(other.enriched.pieces[k].s, scene.enriched.pieces[k].s);
        }
    }
}

// What is said of a point counts the points of the case.
TEST(RefinedScene, SaysWhichPointOfTheCaseIsOutsideTheBody) {
    Case input = plate(1);
    input.cracks[0].points = {{0.0, 10.4}, {2.7, 10.4}, {5.3, 10.4}, {7.0, 21.0}, {9.0, 15.0}};
    try {
        static_cast<void>(refined_scene(input));
        FAIL();
    } catch (const CaseError& error) {
        EXPECT_NE(std::string(error.what()).find("point 3"), std::string::npos) << error.what();
    }
}

// A pressure that travels in 65 536 steps has as many unit loads: 2.5 GB before a sentence about the crack.
TEST(RefinedScene, LooksForRoomBeforeItResolvesLoads) {
    Case input = plate(2);
    input.cracks[0].points.back() = {0.4, 10.4};
    input.boundaries[0].on = "nowhere";
    const std::string said = test::refusal_of([&] { return refined_scene(input); });
    EXPECT_NE(said.find("crack.0.points"), std::string::npos) << said;
}

}  // namespace
}  // namespace stria::coarse
