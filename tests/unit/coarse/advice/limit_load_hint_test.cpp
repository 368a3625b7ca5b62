// Where a limit load may be what is in the way of an equilibrium.
#include "coarse/advice/limit_load_hint.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coarse/zone/refined_scene.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

/// 20 mm wide and 40 mm high.
Scene plate_that(bool may_yield, Control control = Control::Load) {
    Case input = test::pulled_plate(4.0, may_yield, false);
    input.mesh.height = 40.0;
    Scene scene = refined_scene(input);
    scene.input.load.control = control;
    return scene;
}

TEST(LimitLoads, AreOfBodiesThatYieldUnderForces) {
    EXPECT_EQ(limit_load_hint(plate_that(false), 100.0), "");
    EXPECT_TRUE(std::isinf(gives_way_at(plate_that(false))));
    EXPECT_EQ(limit_load_hint(plate_that(true, Control::Displacement), 100.0), "");
    EXPECT_TRUE(std::isinf(gives_way_at(plate_that(true, Control::Displacement))));
    Scene unloaded = plate_that(true);
    unloaded.unit_force.setZero();
    EXPECT_EQ(limit_load_hint(unloaded, 100.0), "");
    EXPECT_TRUE(std::isinf(gives_way_at(unloaded)));
}

TEST(LimitLoads, AreReachedWhereABoundaryMovesByATenthOfTheBody) {
    EXPECT_DOUBLE_EQ(gives_way_at(plate_that(true)), 4.0);
    EXPECT_NE(limit_load_hint(plate_that(true), 1.9).find("; if the body bears no more"), std::string::npos);
    EXPECT_NE(limit_load_hint(plate_that(true), 4.1).find("boundary has moved by 4.1 mm"), std::string::npos);
}

/// 40 mm wide and 20 mm high, about a place that is no corner of it.
TEST(LimitLoads, AreToldByTheSizeOfTheBodyAndNotByItsPlace) {
    Case input = test::pulled_plate(4.0, true, false);
    input.mesh.width = 40.0;
    Scene scene = refined_scene(input);
    Mesh shifted = *scene.mesh;
    for (Vec2& node : shifted.nodes) node += Vec2(500.0, 700.0);
    scene.mesh = BodyMesh(shifted);
    EXPECT_DOUBLE_EQ(gives_way_at(scene), 4.0);
    EXPECT_NE(limit_load_hint(scene, 3.9).find("; if the body bears no more"), std::string::npos);
    EXPECT_NE(limit_load_hint(scene, 4.1).find("boundary has moved by 4.1 mm"), std::string::npos);
}

}  // namespace
}  // namespace stria::coarse
