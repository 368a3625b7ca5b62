// What a testing machine would read of a body.
#include "coarse/model/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "coarse/zone/refined_scene.hpp"
#include "common/error.hpp"
#include "common/integration/crack_faces.hpp"
#include "tests/support/load_cases.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

// Of the displacement u_y = (1 + 3 x + 0.5 y) / 1000 the ends of a plate 20 mm high part by 0.01, whatever the rest.
double displacement_of(const Case& input) {
    const Scene scene = refined_scene(input);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    const auto is_tied = [&](int node) {
        return std::ranges::any_of(scene.enriched.tied, [&](const TiedNode& tied) { return tied.node == node; });
    };
    for (int node = 0; node < std::ssize(scene.mesh->nodes); ++node) {
        if (is_tied(node)) continue;
        const Vec2& x = scene.mesh->nodes.at(static_cast<std::size_t>(node));
        u[scene.enriched.unknown(node, 0, 1)] = 1e-3 * (1.0 + 3.0 * x.x() + 0.5 * x.y());
    }
    return scene.displacement_weights.dot(u);
}

TEST(Displacement, OfAFreeBodyIsWhatItsLoadsDoWorkOn) {
    Case input = test::pulled_plate(2.0, false, false);
    EXPECT_NEAR(displacement_of(input), 0.01, 1e-12);
    std::ranges::reverse(input.boundaries);
    EXPECT_NEAR(displacement_of(input), 0.01, 1e-12);
}

// Nodes that hang on an edge have no unknowns of their own.
TEST(Displacement, OfAFreeBodyIsTheSameOnARefinedMesh) {
    Case input = test::pulled_plate(2.0, true, false);
    input.fine.refine = 4;
    input.fine.radius = 6.0;
    EXPECT_NEAR(displacement_of(input), 0.01, 1e-12);
}

/// Pulled at its top alone, and held at the bottom.
Case held_plate() {
    Case input = test::pulled_plate(2.0, false, false);
    input.boundaries[1].traction.reset();
    input.boundaries[1].displacement = {0.0, 0.0};
    return input;
}

TEST(Displacement, OfAHeldBodyIsTheMeanOfAnEdgeThatIsPulledEvenly) {
    EXPECT_NEAR(displacement_of(held_plate()), 1e-3 * (1.0 + 30.0 + 10.0), 1e-12);
}

// The mean is 0.041. A traction that grows by 1/20 of its mean per mm works on 1/20 of 0.003 (20^2 / 12) more.
TEST(Displacement, OfAHeldBodyIsWhatUnevenTractionsDoWorkOn) {
    Case input = held_plate();
    input.boundaries[0].traction_gradient(1, 0) = 1.0 / 20.0;
    input.boundaries[0].origin = Vec2(10.0, 0.0);
    EXPECT_NEAR(displacement_of(input), 0.041 + 0.003 / 20.0 * 400.0 / 12.0, 1e-12);
}

// The ends of a row of elements are all of its nodes.
TEST(Supports, ThatHoldEveryNodeAreRefused) {
    Case input = held_plate();
    input.cracks.clear();
    input.mesh.size = input.mesh.height;
    static_cast<void>(refined_scene(input));
    input.boundaries[0].traction.reset();
    input.boundaries[0].displacement = {0.0, 0.01};
    EXPECT_THROW(static_cast<void>(refined_scene(input)), CaseError);
}

// Whether a factor of their own loads them or not, held or free.
TEST(Displacement, OfALoadCaseIsWhatItsLoadsDoWorkOn) {
    for (const bool held : {true, false}) {
        Case input = held ? held_plate() : test::pulled_plate(2.0, false, false);
        for (BoundarySection& section : input.boundaries) {
            if (!section.traction) continue;
            section.traction_gradient(1, 0) = section.traction->y() / 20.0;
            section.origin = Vec2(10.0, 0.0);
        }
        const double of_load = displacement_of(input);
        input.load_cases = {test::lagging_load("pulls", 1.0)};
        for (BoundarySection& section : input.boundaries)
            if (section.traction) section.load_case = "pulls";
        EXPECT_NEAR(displacement_of(input), of_load, 1e-12) << held;
    }
}

// An edge is pressed as by a pin: what the pressure does work on over its resultant, not the mean.
TEST(Displacement, UnderAPinIsWhatItsPressureDoesWorkOn) {
    Case input = held_plate();
    const double mean = displacement_of(input);
    input.boundaries[0].traction.reset();
    input.boundaries[0].pressure = -1.0;
    input.boundaries[0].cosine = Vec2(0.0, -1.0);
    EXPECT_NEAR(displacement_of(input), mean, 1e-12) << "the same everywhere on a straight edge";
    input.boundaries[0].pressure = 1.0;
    input.boundaries[0].centre = Vec2(0.0, 30.0);
    const Scene scene = refined_scene(input);
    const double resultant = loaded_boundary(scene.mesh, scene.input, scene.loads).value().resultant.norm();
    EXPECT_TRUE(scene.displacement_weights.isApprox(scene.unit_force / resultant, 1e-12));
    EXPECT_GT(std::abs(displacement_of(input) / mean + 1.0), 0.02);
}

// A crack along element edges that begins at a node of a held edge does not open there, on neither side.
TEST(Supports, HoldTheMouthOfACrackOnTheEdge) {
    Case input = test::pulled_plate(2.0, false, false);
    for (const double height : {10.0, 10.4}) {
        for (Vec2& point : input.cracks[0].points) point.y() = height;
        input.boundaries[0].on = "left";
        input.boundaries[0].traction.reset();
        input.boundaries[0].displacement = {0.0, 0.0};
        const Scene scene = refined_scene(input);
        const FaceStation mouth = face_station_at(scene.enriched, 0, 0.0);
        ASSERT_FALSE(mouth.terms.empty());
        for (const FaceStation::Term& term : mouth.terms)
            for (const int component : {0, 1})
                EXPECT_TRUE(term.value == 0.0 || std::ranges::binary_search(scene.prescribed, term.unknown + component,
                                                                            {}, &PrescribedUnknown::unknown));
    }
}

// A node on the crack is of the face on the left. A support of the other face alone would hold both.
TEST(Supports, ThatEndAtACrackAreOnItsLeft) {
    Case input = test::pulled_plate(2.0, false, false);
    for (Vec2& point : input.cracks[0].points) point.y() = 10.0;
    Mesh body = refined_scene(input).mesh;
    input.boundaries[0].on = "half";
    input.boundaries[0].traction.reset();
    input.boundaries[0].displacement = {0.0, 0.0};
    for (const bool upper : {true, false}) {
        body.boundary["half"].clear();
        for (const BoundaryEdge& edge : body.boundary.at("left")) {
            const EdgeGeometry ends = edge_geometry(body, edge);
            if ((ends.from.y() + ends.to.y() > 20.0) == upper) body.boundary["half"].push_back(edge);
        }
        const BodyMesh named(body);
        if (upper)
            EXPECT_NO_THROW(make_scene(input, named));
        else
            EXPECT_THROW(make_scene(input, named), CaseError);
        std::ranges::reverse(input.cracks[0].points);
        if (upper)
            EXPECT_THROW(make_scene(input, named), CaseError);
        else
            EXPECT_NO_THROW(make_scene(input, named));
        std::ranges::reverse(input.cracks[0].points);
    }
}

}  // namespace
}  // namespace stria::coarse
