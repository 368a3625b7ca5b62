// Interfaces from side to side of a block, pressed together: uniform states that stick (docs/references.md 5.3), a
// pressure that varies along one (5.4), and a wedge that is pushed up another (5.7). And a crack that is pressed from
// all sides.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "coarse/zone/refined_scene.hpp"
#include "common/case/case_questions.hpp"
#include "common/fem/quadrature.hpp"
#include "common/integration/crack_faces.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/one_equilibrium.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

// references 5.3: a square with an interface from side to side, pressed between clamped ends. nu = 0, so that the state
// is uniform; units of 20 m, MPa for the Pa of the source.
TEST(Interface, SticksWithTheTractionsOfAUniformState) {
    const auto pressed = [](double degrees, double friction) {
        const double rise = 0.5 * std::tan(degrees * std::numbers::pi / 180.0);
        Case input = specimen("plate", 1.0, {{0.0, 0.503 - rise}, {1.0, 0.503 + rise}});
        input.mesh.size = 1.0 / 11.0;
        input.material.young = 100.0;
        input.material.poisson = 0.0;
        input.fine.enrichment = Enrichment::None;
        input.cracks[0].contact = ContactSection{friction};
        for (const char* on : {"top", "bottom"}) {
            BoundarySection held;
            held.on = on;
            held.displacement = {0.0, on == std::string("top") ? -0.05 : 0.0};
            input.boundaries.push_back(held);
        }
        return equilibrate(coarse::refined_scene(input), 1.0);
    };
    const auto expect_uniform = [](const Equilibrated& result, double pressure, double shear) {
        EXPECT_TRUE(result.newton.converged) << result.newton.table();
        ASSERT_FALSE(result.zone.faces.empty());
        double farthest = pressure, farthest_shear = shear;
        for (const coupling::FaceSample& face : result.zone.faces) {
            if (std::abs(face.pressure - pressure) > std::abs(farthest - pressure)) farthest = face.pressure;
            if (std::abs(std::abs(face.shear) - shear) > std::abs(farthest_shear - shear))
                farthest_shear = std::abs(face.shear);
            EXPECT_EQ(face.status, 1);
        }
        const auto row = rows_of({.scene = fmt::format("interface that sticks, {} degrees", shear == 0.0 ? 0.0 : 22.5),
                                  .source = "Code_Aster SSNV182 (5.3)",
                                  .within = 1e-6,
                                  .mesh = "11 x 11",
                                  .scale = pressure});
        row("pressure where it is farthest off, Pa", pressure, farthest);
        row("shear where it is farthest off, Pa", shear, farthest_shear);
    };
    expect_uniform(pressed(0.0, 0.1), 5.0, 0.0);
    expect_uniform(pressed(22.5, 0.414214 + 1e-6), 4.267767, 1.767767);
    const Equilibrated slid = pressed(22.5, 0.414213);
    const auto slides = [](const coupling::FaceSample& face) { return face.status == 2; };
    EXPECT_TRUE(std::ranges::any_of(slid.zone.faces, slides));
}

/// Pressure (100 - (x - 10)^2 / 2) / 10 MPa on the top edge: the source's, for its E of 1e11 Pa.
double pressure_on_top(double x) { return 10.0 - 0.05 * (x - 10.0) * (x - 10.0); }

void press_top(coarse::Scene& scene) {
    scene.unit_force.setZero();
    for (const BoundaryEdge& e : scene.mesh->boundary.at("top")) {
        const coarse::EdgeGeometry edge = coarse::edge_geometry(scene.mesh, e);
        const std::array<int, 2> nodes = coarse::edge_nodes(scene.mesh, e);
        for (const LinePoint& g : gauss_line(3)) {
            const double along = 0.5 * (1.0 + g.xi);
            const double force = 0.5 * g.weight * edge.length() * pressure_on_top(edge.at(along).x());
            scene.unit_force[scene.enriched.unknown(nodes[0], 0, 1)] -= (1.0 - along) * force;
            scene.unit_force[scene.enriched.unknown(nodes[1], 0, 1)] -= along * force;
        }
    }
}

/// Pressure in the middle of an interface at 17.5 of a block of 20 x 20 that stands on its foot, MPa.
double pressure_in_the_middle(int elements) {
    Case input = specimen("plate", 20.0, {{0.0, 17.5}, {20.0, 17.5}});
    input.mesh.width = 20.0;
    input.mesh.size = 20.0 / elements;
    input.material.young = 1e5;
    input.material.poisson = 0.0;
    input.fine.enrichment = Enrichment::None;
    input.cracks[0].contact = ContactSection{1.0};
    BoundarySection foot, top;
    foot.on = "bottom", top.on = "top";
    foot.displacement = {0.0, 0.0};
    top.displacement[0] = 0.0;
    top.traction = Vec2(0.0, -1.0);  // marks the edge as loaded; press_top() replaces it
    input.boundaries = {foot, top};
    coarse::Scene scene = coarse::refined_scene(input);
    press_top(scene);
    const Equilibrated result = equilibrate(scene, 1.0);
    EXPECT_TRUE(result.newton.converged) << result.newton.table();
    double nearest = 1e300, pressure = 0.0, worst = 0.0;
    for (std::size_t k = 0; k < result.zone.faces.size(); ++k) {
        const coupling::FaceSample& face = result.zone.faces[k];
        EXPECT_EQ(face.status, 1);
        if (std::abs(face.x - 10.0) < nearest) nearest = std::abs(face.x - 10.0), pressure = face.pressure;
        if (k > 0) worst = std::max(worst, std::abs(face.pressure - result.zone.faces[k - 1].pressure));
    }
    std::cout << fmt::format("5.4, {} elements: {:.5f} MPa in the middle, {:.3f} between stations at most\n", elements,
                             pressure, worst);
    return pressure;
}

// The value of the source is that of its mesh of 20 x 20.
TEST(PressedInterface, PressureDoesNotOscillateAndConverges) {
    const double coarsest = pressure_in_the_middle(10), coarse = pressure_in_the_middle(20),
                 fine = pressure_in_the_middle(40);
    for (const auto& [elements, pressure] : {std::pair(20, coarse), {40, fine}})
        verify({.scene = "pressure that varies along an interface",
                .source = "Code_Aster SSNV186 (5.4)",
                .quantity = "pressure in the middle, MPa",
                .reference = 9.528440,
                .ours = pressure,
                .within = 0.01,
                .mesh = fmt::format("{0} x {0}", elements)});
    EXPECT_LT(std::abs(fine - coarse), std::abs(coarse - coarsest));
}

/// Force along x for the weight on top, from the tractions of the faces, of a block that is cut by a slope of 0.1 and
/// pushed up it; and the force along y over that weight.
Vec2 pushed_up(double friction, int elements) {
    Case input = specimen("plate", 1.0, {{0.0, 0.703}, {1.0, 0.803}});
    input.mesh.size = 1.0 / elements;
    input.fine.enrichment = Enrichment::None;
    input.cracks[0].contact = ContactSection{friction};
    BoundarySection foot, pushed, weighed;
    foot.on = "bottom", pushed.on = weighed.on = "top";
    foot.displacement = {0.0, 0.0};
    pushed.displacement[0] = 1e-4;
    weighed.traction = Vec2(0.0, -1.0);
    input.boundaries = {foot, pushed, weighed};
    const coarse::Scene scene = coarse::refined_scene(input);
    const Equilibrated result = equilibrate(scene, 1.0);
    EXPECT_TRUE(result.newton.converged) << result.newton.table();
    const std::vector<FaceStation> stations = face_stations(scene.enriched, 0, subcells_at_crack(scene.input.fine), 4);
    const Vec2 tangent = Vec2(1.0, 0.1).normalized(), normal(-tangent.y(), tangent.x());
    Vec2 force = Vec2::Zero();
    for (std::size_t k = 0; k < stations.size(); ++k) {
        const coupling::FaceSample& face = result.zone.faces[k];
        EXPECT_EQ(face.status, friction > 0.0 ? 2 : 1);
        force += stations[k].weight * (face.shear * tangent - face.pressure * normal);
    }
    return force;
}

// The wedge of NAFEMS CGS-4: F / G = (tan a + mu) / (1 - mu tan a), here for a block that also bends.
TEST(PressedInterface, AWedgeNeedsTheForceOfItsFriction) {
    for (const auto& [friction, exact] : {std::pair{0.0, 0.1}, {0.1, 0.202020}, {0.2, 0.306122}, {0.3, 0.412371}}) {
        double before = 1e300;
        for (const int elements : {11, 41}) {
            const Vec2 force = pushed_up(friction, elements);
            std::cout << fmt::format("5.7, friction {}, {} elements: F / G = {:.6f}, weight {:.6f}\n", friction,
                                     elements, force.x(), -force.y());
            verify({.scene = fmt::format("wedge, friction {}", friction),
                    .source = "NAFEMS CGS-4 (5.7)",
                    .quantity = "F / G",
                    .reference = exact,
                    .ours = force.x(),
                    .within = 0.01,
                    .mesh = fmt::format("{0} x {0}", elements)});
            EXPECT_NEAR(force.y(), -1.0, 0.01);
            EXPECT_LT(std::abs(force.x() - exact), 0.5 * before);
            before = std::abs(force.x() - exact);
        }
    }
}

/// How far the pressure on a crack's faces is off, of that on all sides of its plate; with the functions of eq. (2).
double error_of_pressure(const std::vector<Vec2>& crack, int elements = 10,
                         Enrichment enrichment = Enrichment::Topological) {
    Case input = specimen("plate", 1.0, crack);
    input.mesh.size = 1.0 / elements;
    input.fine.enrichment = enrichment;
    input.cracks[0].contact = ContactSection{};
    for (const char* on : {"top", "bottom", "left", "right"}) {
        input.boundaries.emplace_back();
        input.boundaries.back().on = on;
        input.boundaries.back().pressure = 100.0;
    }
    const Equilibrated result = equilibrate(coarse::refined_scene(input), 1.0);
    EXPECT_TRUE(result.newton.converged) << result.newton.failure;
    EXPECT_FALSE(result.zone.faces.empty());
    double worst = 0.0;
    for (const coupling::FaceSample& face : result.zone.faces)
        worst = std::max(worst, std::abs(face.pressure - 100.0) / 100.0);
    return worst;
}

// The jump goes with r^(1/2): the rule is exact for it along a straight crack, and is repeated towards the tip on what
// lies behind a bend. Once the last was 0.07 % off.
TEST(PressedInterface, BearsThePressureUpToItsTip) {
    EXPECT_LT(error_of_pressure({{0.0, 0.63}, {0.56, 0.68}}), 1e-9);
    EXPECT_LT(error_of_pressure({{0.0, 0.63}, {0.54, 0.68}, {0.546, 0.684}}), 1e-6);
    EXPECT_LT(error_of_pressure({{0.0, 0.63}, {0.536, 0.67}, {0.536, 0.677}}), 1e-6);
}

// A plate in tension, which opens all of a bent crack. Faces that a multiplier took for closed doubled K.
TEST(PressedInterface, OfABentCrackInTensionGapes) {
    for (const double tip : {6.06, 6.243, 6.6, 7.1}) {
        Case input = specimen("sent", 20.0, {{0.0, 8.53}, {4.1, 9.7}, {tip, 9.64}});
        input.mesh.width = 10.0;
        input.mesh.size = 1.0;
        input.cracks[0].contact = ContactSection{};
        for (const double side : {1.0, -1.0}) {
            input.boundaries.emplace_back();
            input.boundaries.back().on = side > 0.0 ? "top" : "bottom";
            input.boundaries.back().traction = Vec2(0.0, side);
        }
        const Equilibrated result = equilibrate(coarse::refined_scene(input), 70.0);
        EXPECT_TRUE(result.newton.converged) << result.newton.failure;
        EXPECT_FALSE(result.zone.faces.empty());
        for (const coupling::FaceSample& face : result.zone.faces) {
            EXPECT_EQ(face.status, 0) << tip << ' ' << face.x;
            EXPECT_GT(face.opening, 0.0) << tip << ' ' << face.x;
        }
    }
}

/// Of an edge crack askew in a plate of 20 mm by 40 on elements of 1 mm, by how much its faces overlap in the first of
/// them, over the largest opening. The stress of the load ascends from none at `zero`: it presses the mouth, and the
/// tip opens.
double overlap_of_bent_plate(const std::vector<Vec2>& crack, double zero) {
    Case input = specimen("sent", 40.0, crack);
    input.mesh.width = 20.0;
    input.mesh.size = 1.0;
    input.cracks[0].contact = ContactSection{};
    for (const double side : {1.0, -1.0}) {
        input.boundaries.emplace_back();
        input.boundaries.back().on = side > 0.0 ? "top" : "bottom";
        input.boundaries.back().traction = Vec2::Zero();
        input.boundaries.back().traction_gradient(1, 0) = side;
        input.boundaries.back().origin = {zero, 0.0};
    }
    const Equilibrated result = equilibrate(coarse::refined_scene(input), 10.0);
    EXPECT_TRUE(result.newton.converged) << result.newton.failure;
    EXPECT_GT(result.zone.faces.front().pressure, 0.0);
    double deepest = 0.0, widest = 0.0;
    for (const coupling::FaceSample& face : result.zone.faces) {
        if (face.x < 1.0) deepest = std::max(deepest, -face.opening);
        widest = std::max(widest, face.opening);
    }
    return deepest / widest;
}

// A corner of the element at the mouth is cut off. With one multiplier at the mouth, whose hat spans two elements,
// faces overlapped by 5.7 % there: those that touch at the mouth alone meet in the mean over it.
TEST(PressedInterface, OfACrackPressedAtItsMouthHardlyOverlap) {
    EXPECT_LT(overlap_of_bent_plate({{0.0, 18.346}, {4.478, 14.818}}, 1.849), 0.02);
    EXPECT_LT(overlap_of_bent_plate({{0.0, 21.654}, {4.478, 25.182}}, 1.849), 0.02) << "in a mirror";
}

// Each was found by stria_stress. Which side of the crack an element lies on, nodes of the tip's element alone do not
// tell where the crack bends before its tip; and a piece that comes back to the edge it came from opens no edge.
TEST(PressedInterface, OfCracksThatBendAtTheirTips) {
    const struct {
        int elements;
        std::vector<Vec2> crack;  // in elements
    } scenes[] = {
        {8, {{0.0, 3.873}, {3.0, 5.0}, {3.493, 4.927}, {3.715, 5.055}, {3.723, 5.053}}},
        {15, {{5.299, 7.449}, {11.529, 9.026}, {11.605, 9.006}, {11.608, 9.003}}},
        {7, {{0.0, 3.0}, {1.959, 4.135}, {2.000004, 4.498}, {2.0, 4.741}}},
        {8, {{2.252, 3.97}, {4.83, 5.344}, {4.872, 5.343}, {5.0, 5.0}, {5.017, 4.993}}},
        {9, {{2.93267517211, 5.0}, {5.0, 3.0}, {5.0, 2.49974612985}, {5.0, 2.0}, {5.00508304091, 1.99400951844}}},
    };
    for (const auto& [elements, crack] : scenes) {
        std::vector<Vec2> points = crack;
        for (Vec2& x : points) x /= elements;
        EXPECT_LT(error_of_pressure(points, elements), 3e-3) << elements;
        EXPECT_LT(error_of_pressure(points, elements, Enrichment::None), 1e-3) << elements;
    }
}

// Behind a kink at a node the crack runs along one edge more: all that jumps there jumps at the kink.
TEST(PressedInterface, OfOneEdgeBehindAKinkBearsThePressure) {
    for (const Vec2& end : {Vec2(0.3, 0.7), Vec2(0.2, 0.6)})
        EXPECT_LT(error_of_pressure({{0.0, 0.85}, {0.2, 0.7}, end}, 10, Enrichment::None), 1e-8);
}

}  // namespace
}  // namespace stria::test
