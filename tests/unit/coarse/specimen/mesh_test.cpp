// Specimen meshes: graded axes, named edges, pins, and what the case may not ask.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coarse/specimen/compact_tension.hpp"
#include "coarse/specimen/graded_axis.hpp"
#include "coarse/specimen/specimen.hpp"
#include "coarse/specimen/structured.hpp"
#include "common/error.hpp"
#include "common/geometry/vec2.hpp"
#include "common/index.hpp"
#include "tests/support/refusal.hpp"

namespace stria::coarse {
namespace {

Case plain_case() {
    Case scene;
    scene.mesh = {.specimen = "sent", .width = 50.0, .height = 200.0, .size = 5.0, .grading = {}};
    scene.cracks = {CrackSection{.points = {{0.0, 100.0}, {20.0, 100.0}}, .contact = {}, .notch = 0.0}};
    return scene;
}

AxisGrading anchor_at(double x, double size, double outer_size, double radius) {
    return {x, x, size, outer_size, radius, 0.25, true};
}

/// The cell that holds x, as [first, second].
std::pair<double, double> cell_at(const std::vector<double>& positions, double x) {
    const auto above = std::upper_bound(positions.begin(), positions.end(), x);
    return {*(above - 1), *above};
}

double largest_ratio(const std::vector<double>& positions) {
    double largest = 1.0;
    for (std::size_t k = 2; k < positions.size(); ++k) {
        const double ratio = (positions[k] - positions[k - 1]) / (positions[k - 1] - positions[k - 2]);
        largest = std::max({largest, ratio, 1.0 / ratio});
    }
    return largest;
}

std::string refusal(const Case& scene) {
    return test::refusal_of([&] { return make_mesh(scene.mesh, scene.cracks); });
}

TEST(GradedAxis, IsUniformWithoutGradings) {
    const std::vector<double> positions = graded_axis(10.0, 3.0, {});
    ASSERT_EQ(positions.size(), 4U);
    EXPECT_NEAR(positions[1], 10.0 / 3.0, 1e-14);
    EXPECT_EQ(positions.back(), 10.0);
    EXPECT_EQ(graded_axis(1.0, 5.0, {}), (std::vector<double>{0.0, 1.0}));
}

TEST(GradedAxis, PutsAnchorsInTheMiddleOfSmallCells) {
    for (const double place : {0.8, 7.3, 20.0, 25.0, 49.0}) {
        for (const double size : {0.01, 0.37, 1.0}) {
            const std::vector<AxisGrading> gradings{anchor_at(place, size, 2.0 * size, 4.0)};
            const std::vector<double> positions = graded_axis(50.0, 5.0, gradings);
            const auto [low, high] = cell_at(positions, place);
            EXPECT_NEAR(0.5 * (low + high), place, 1e-12);
            EXPECT_LE(high - low, size * (1.0 + 1e-12));
            EXPECT_LT(largest_ratio(positions), 2.6) << place << ' ' << size;
            for (std::size_t k = 1; k < positions.size(); ++k) {
                const double cell = positions[k] - positions[k - 1];
                const bool within = std::max(std::abs(positions[k] - place), std::abs(positions[k - 1] - place)) <= 4.0;
                EXPECT_LE(cell, (within ? 2.0 * size : 5.0) * (1.0 + 1e-12));
                EXPECT_GT(cell, 0.0);
            }
        }
    }
}

TEST(GradedAxis, TakesSeveralAnchorsAndIntervals) {
    const std::vector<AxisGrading> gradings{
        anchor_at(10.0, 0.5, 0.5, 1.0), anchor_at(12.2, 0.2, 0.4, 1.0), {30.0, 34.0, 0.1, 0.1, 0.0, 0.5, false}};
    const std::vector<double> positions = graded_axis(50.0, 2.0, gradings);
    for (const double place : {10.0, 12.2}) {
        const auto [low, high] = cell_at(positions, place);
        EXPECT_NEAR(0.5 * (low + high), place, 1e-12);
    }
    for (double x = 30.05; x < 34.0; x += 0.1) {
        const auto [low, high] = cell_at(positions, x);
        if (low >= 30.0 && high <= 34.0) {
            EXPECT_LE(high - low, 0.1 * (1.0 + 1e-12));
        }
    }
    EXPECT_LT(largest_ratio(positions), 2.6);
}

TEST(GradedAxis, IsSymmetricIfTheWishesAre) {
    const std::vector<AxisGrading> gradings{anchor_at(30.0, 0.3, 0.6, 2.0), anchor_at(70.0, 0.3, 0.6, 2.0)};
    const std::vector<double> positions = graded_axis(100.0, 4.0, gradings);
    for (std::size_t k = 0; k < positions.size(); ++k) {
        EXPECT_NEAR(positions[k] + positions[positions.size() - 1 - k], 100.0, 1e-11);
    }
}

TEST(GradedAxis, MakesNoSliversNextToTheEnds) {
    for (const double place : {0.0, 0.001, 0.3, 0.49, 0.51, 0.74, 0.76, 1.01, 1.49}) {
        const std::vector<AxisGrading> gradings{anchor_at(place, 1.0, 1.0, 5.0)};
        const std::vector<double> positions = graded_axis(40.0, 2.0, gradings);
        EXPECT_LT(largest_ratio(positions), 2.6) << place;
        EXPECT_LE(positions[1], 1.0 + 1e-12);
    }
}

TEST(GradedAxis, RefusesMoreCellsThanMemoryHolds) {
    EXPECT_THROW(static_cast<void>(graded_axis(1.0, 1e-9, {})), CaseError);
}

BoundarySection point_at(double x, double y) {
    BoundarySection section;
    section.on = "point";
    section.at = Vec2(x, y);
    return section;
}

TEST(RectangleMesh, HasANodeAtEachPointOfABoundary) {
    Case scene = plain_case();
    scene.mesh.grading = {Grading{.at = {{20.0, 100.0}}, .size = 0.2, .outer_size = 0.4, .radius = 2.0}};
    const std::vector<BoundarySection> points{point_at(50.0, 100.0), point_at(0.0, 13.7), point_at(31.4, 171.9)};
    const Mesh without = make_mesh(scene.mesh, scene.cracks);
    const Mesh mesh = make_mesh(scene.mesh, scene.cracks, {}, points);
    const Vec2 by_chance(0.0, without.nodes[500].y());  // where the lines of the others move what is between
    const Mesh with_all = make_mesh(scene.mesh, scene.cracks, {},
                                    {points[0], points[1], points[2], point_at(by_chance.x(), by_chance.y())});
    EXPECT_TRUE(is_at(without, nearest_node(without, by_chance), by_chance));
    EXPECT_FALSE(is_at(mesh, nearest_node(mesh, by_chance), by_chance));
    EXPECT_TRUE(is_at(with_all, nearest_node(with_all, by_chance), by_chance));
    for (const BoundarySection& point : points) {
        EXPECT_FALSE(is_at(without, nearest_node(without, *point.at), *point.at));
        EXPECT_TRUE(is_at(mesh, nearest_node(mesh, *point.at), *point.at));
    }
    const std::vector<BoundarySection> nodes{
        point_at(0.0, 0.0), point_at(without.nodes[500].x(), without.nodes[500].y()), point_at(60.0, 1.0)};
    EXPECT_EQ(make_mesh(scene.mesh, scene.cracks, {}, nodes).nodes, without.nodes) << "nodes, and outside of the body";
}

TEST(RectangleMesh, HasPositiveElementsThatFillTheBodyAndNamedEdges) {
    Case scene = plain_case();
    scene.mesh.grading = {Grading{.at = {{20.0, 100.0}}, .size = 0.2, .outer_size = 0.4, .radius = 2.0}};
    const Mesh mesh = make_mesh(scene.mesh, scene.cracks);
    double area = 0.0;
    for (const auto& element : mesh.elements) {
        const auto node = [&](std::size_t k) { return mesh.nodes[at(element[k])]; };
        const Vec2 right = node(1) - node(0), up = node(3) - node(0);
        EXPECT_GT(cross(right, up), 0.0);
        area += right.x() * up.y();
    }
    EXPECT_NEAR(area, 50.0 * 200.0, 1e-9);

    ASSERT_EQ(mesh.boundary.size(), 4U);
    const auto length_where = [&](const std::string& name, auto on_edge) {
        double length = 0.0;
        for (const BoundaryEdge& edge : mesh.boundary.at(name)) {
            const auto& element = mesh.elements[at(edge.element)];
            const auto& from = mesh.nodes[at(element[at(edge.edge)])];
            const auto& to = mesh.nodes[at(element[at((edge.edge + 1) % 4)])];
            if (on_edge(from) && on_edge(to)) length += (to - from).norm();
        }
        return length;
    };
    EXPECT_NEAR(length_where("bottom", [](const auto& x) { return x.y() == 0.0; }), 50.0, 1e-10);
    EXPECT_NEAR(length_where("top", [](const auto& x) { return x.y() == 200.0; }), 50.0, 1e-10);
    EXPECT_NEAR(length_where("left", [](const auto& x) { return x.x() == 0.0; }), 200.0, 1e-10);
    EXPECT_NEAR(length_where("right", [](const auto& x) { return x.x() == 50.0; }), 200.0, 1e-10);
}

TEST(RectangleMesh, GradesALineAcrossAndAlongItself) {
    MeshSection section{.specimen = "plate", .width = 50.0, .height = 40.0, .size = 4.0, .grading = {}};
    section.grading = {Grading{.at = {{30.0, 20.0}, {20.0, 20.0}}, .size = 0.5, .outer_size = {}, .radius = 1.0}};
    const Mesh mesh = rectangle_mesh(section);
    for (const auto& element : mesh.elements) {
        const Vec2 low = mesh.nodes[at(element[0])];
        const Vec2 high = mesh.nodes[at(element[2])];
        if (low.x() >= 20.0 && high.x() <= 30.0) {
            EXPECT_LE(high.x() - low.x(), 0.5 + 1e-12);
        }
        EXPECT_FALSE(low.y() == 20.0 || high.y() == 20.0);  // a crack on the line does not run along edges
    }
}

TEST(CompactTension, HasItsOriginOnTheLoadLine) {
    const Mesh mesh =
        compact_tension_mesh({.specimen = "ct", .width = 40.0, .height = 48.0, .size = 1.5, .grading = {}});
    EXPECT_EQ(mesh.nodes.front(), Vec2(-10.0, -24.0));
    EXPECT_EQ(mesh.nodes.back(), Vec2(40.0, 24.0));
    EXPECT_EQ(mesh.load_line, 0.0);
}

TEST(CompactTension, SpreadsItsPinForcesWithoutMoment) {
    for (const double size : {20.0, 4.0, 0.7}) {
        const Mesh mesh =
            compact_tension_mesh({.specimen = "ct", .width = 40.0, .height = 48.0, .size = size, .grading = {}});
        ASSERT_EQ(mesh.pins.size(), 2U);
        for (const auto& [name, pin] : mesh.pins) {
            Vec2 centre = Vec2::Zero();
            double sum = 0.0, widest = 0.0;
            const Vec2 middle(0.0, name == "pin-top" ? 11.0 : -11.0);
            for (const auto& [node, weight] : pin.shares) {
                sum += weight;
                centre += weight * mesh.nodes[at(node)];
                const Vec2 arm = mesh.nodes[at(node)] - middle;
                widest = std::max(widest, std::abs(arm.x()));
                EXPECT_NEAR(arm.norm(), 5.0, 1e-12);
                EXPECT_GT(arm.y() * middle.y(), 0.0);  // outwards
            }
            EXPECT_NEAR(sum, 1.0, 1e-12);
            EXPECT_NEAR(centre.x(), 0.0, 1e-10);  // on the load line
            EXPECT_NEAR(widest, 2.5, 1e-12);      // 30 degrees to either side, whatever the elements
            EXPECT_TRUE(mesh.pins.contains(pin.opposite));
        }
        EXPECT_FALSE(mesh.insert.empty());
    }
}

TEST(CompactTension, HasOpenHolesAndNoStrayNodes) {
    const Mesh mesh =
        compact_tension_mesh({.specimen = "ct", .width = 40.0, .height = 48.0, .size = 0.4, .grading = {}});
    std::vector<char> used(mesh.nodes.size(), 0);
    double area = 0.0;
    for (const auto& nodes : mesh.elements) {
        const auto x = [&](int corner) { return mesh.nodes[at(nodes[at(corner)])]; };
        for (const int corner : {0, 1, 2, 3})
            EXPECT_GT(cross(x((corner + 1) % 4) - x(corner), x((corner + 3) % 4) - x(corner)), 0.0);
        area += 0.5 * cross(x(2) - x(0), x(3) - x(1));
        for (const int node : nodes) used[at(node)] = 1;
    }
    const double holes = 2.0 * 3.14159 * 25.0;
    EXPECT_NEAR(area, 50.0 * 48.0 - holes, 0.002 * holes);
    EXPECT_EQ(std::ranges::count(used, static_cast<char>(0)), 0);
    for (const char* hole : {"hole-top", "hole-bottom"}) {
        for (const BoundaryEdge& edge : mesh.boundary.at(hole)) {
            const auto& nodes = mesh.elements[at(edge.element)];
            const Vec2& end = mesh.nodes[at(nodes[at(edge.edge)])];
            EXPECT_NEAR((end - Vec2(0.0, end.y() > 0.0 ? 11.0 : -11.0)).norm(), 5.0, 1e-12);
        }
    }
}

TEST(CompactTension, RefusesACrackThroughAPin) {
    Case scene;
    scene.mesh = {.specimen = "ct", .width = 40.0, .height = 48.0, .size = 1.5, .grading = {}};
    scene.cracks = {CrackSection{.points = {{-10.0, 0.0}, {20.0, 0.0}}, .contact = {}, .notch = 0.0}};
    EXPECT_EQ(refusal(scene), "accepted");
    scene.cracks[0].points[1] = {0.0, 12.0};
    EXPECT_NE(refusal(scene).find("insert of a pin"), std::string::npos);
}

TEST(MakeMesh, NamesTheKeyThatIsWrong) {
    const auto starts = [](const std::string& text, const std::string& key) { return text.rfind(key + ":", 0) == 0; };
    Case scene = plain_case();
    EXPECT_EQ(refusal(scene), "accepted");
    scene.mesh.specimen = "snet";
    EXPECT_TRUE(starts(refusal(scene), "mesh.specimen"));
    EXPECT_NE(refusal(scene).find("available: sent, mt, ct, plate"), std::string::npos);
    scene = plain_case();
    scene.mesh.grading = {Grading{.at = {{51.0, 100.0}}, .size = 1.0, .outer_size = {}}};
    EXPECT_TRUE(starts(refusal(scene), "mesh.grading.0.at"));
    scene.mesh.grading = {Grading{.at = {{1.0, 1.0}}, .size = 1e-5, .outer_size = {}}};
    EXPECT_TRUE(starts(refusal(scene), "mesh.grading.0.size"));
}

TEST(MakeMesh, WantsCracksThatMeetTheBody) {
    const auto with_crack = [](std::vector<Vec2> points) {
        Case scene = plain_case();
        scene.cracks.push_back(CrackSection{.points = std::move(points), .contact = {}, .notch = 0.0});
        return refusal(scene);
    };
    EXPECT_EQ(with_crack({{-5.0, 30.0}, {10.0, 40.0}}), "accepted");  // a mouth outside
    EXPECT_EQ(with_crack({{-5.0, 30.0}, {60.0, 40.0}}), "accepted");  // cut in two, no tip
    EXPECT_NE(with_crack({{60.0, 10.0}, {70.0, 10.0}}), "accepted");
    EXPECT_NE(with_crack({{0.0, 10.0}, {0.0, 20.0}}), "accepted");  // along the boundary
    EXPECT_NE(with_crack({{10.0, 10.0}, {60.0, 20.0}, {10.0, 30.0}}), "accepted");
}

}  // namespace
}  // namespace stria::coarse
