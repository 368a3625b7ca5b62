// Boundary sections resolved on a mesh, the balance of free rigid motions, and the boundary of the history.
#include "coarse/model/loads/boundary_conditions.hpp"
#include "coarse/model/loads/held_loads.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "coarse/model/loads/loads_of_case.hpp"
#include "coarse/model/rigid_motions.hpp"
#include "coarse/specimen/structured.hpp"
#include "common/error.hpp"
#include "common/index.hpp"
#include "tests/support/load_cases.hpp"
#include "tests/support/refusal.hpp"

namespace stria::coarse {
namespace {

const Mesh mesh = grid_mesh(std::vector<double>{0.0, 1.0, 2.5, 4.0}, std::vector<double>{0.0, 2.0, 3.0});  // 4 x 3 mm

BoundarySection traction_on(const std::string& name, double x, double y) {
    BoundarySection section;
    section.on = name;
    section.traction = Vec2(x, y);
    return section;
}

BoundarySection held(const std::string& name, std::optional<double> x, std::optional<double> y) {
    BoundarySection section;
    section.on = name;
    section.displacement = {x, y};
    return section;
}

BoundarySection at_point(double x, double y) {
    BoundarySection section;
    section.on = "point";
    section.at = Vec2(x, y);
    return section;
}

BoundarySection held_at(double x, double y, std::optional<double> ux, std::optional<double> uy) {
    BoundarySection section = at_point(x, y);
    section.displacement = {ux, uy};
    return section;
}

BoundarySection force_at(double x, double y, double fx, double fy) {
    BoundarySection section = at_point(x, y);
    section.force = Vec2(fx, fy);
    return section;
}

Vec2 resultant(const std::vector<BoundarySection>& sections) {
    Vec2 sum = Vec2::Zero();
    for (const AppliedForce& applied : applied_forces(mesh, resolve_boundaries(mesh, sections))) sum += applied.force;
    return sum;
}

std::string refusal(const std::vector<BoundarySection>& sections) {
    return test::refusal_of([&] { return analyse_rigid_motions(mesh, resolve_boundaries(mesh, sections)); });
}

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::optional<LoadedBoundary> loaded_among(const Mesh& body, const std::vector<BoundarySection>& sections) {
    Case input;
    input.boundaries = sections;
    return loaded_boundary(body, input, resolve_loads(body, input));
}

FreeMotions motions_of(const std::vector<BoundarySection>& sections) {
    return analyse_rigid_motions(mesh, resolve_boundaries(mesh, sections));
}

/// Supports and pins together must leave no motion: the 3 x 3 Gram matrix of what they feel is regular.
bool holds_the_body(const std::vector<BoundarySection>& sections, const FreeMotions& motions) {
    Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
    const auto add = [&](int node, int component) {
        const Vec2& x = mesh.nodes[at(node)];
        const Eigen::Vector3d row = component == 0 ? Eigen::Vector3d(1, 0, -x.y()) : Eigen::Vector3d(0, 1, x.x());
        gram += row * row.transpose();
    };
    for (const auto& displacement : resolve_boundaries(mesh, sections).displacements) {
        add(displacement.node, displacement.component);
    }
    for (const Pin& pin : motions.pins) add(pin.node, pin.component);
    return std::abs(gram.determinant()) > 1e-6;
}

TEST(Boundaries, IntegrateTractionsToTheirResultant) {
    EXPECT_LT((resultant({traction_on("top", 1.0, 2.0)}) - Vec2(4.0, 8.0)).norm(), 1e-14);
    BoundarySection pressure;
    pressure.on = "right";
    pressure.pressure = 5.0;
    EXPECT_LT((resultant({pressure}) - Vec2(-15.0, 0.0)).norm(), 1e-14);  // inwards
    BoundarySection gradient;
    gradient.on = "top";
    gradient.origin = Vec2(1.0, 0.0);
    gradient.traction_gradient << 0.0, 0.0, 3.0, 0.0;  // t_y = 3 (x - 1)
    EXPECT_LT((resultant({gradient}) - Vec2(0.0, 3.0 * (8.0 - 4.0))).norm(), 1e-13);
    EXPECT_EQ(resultant({force_at(4.0, 3.0, 1.0, -2.0)}), Vec2(1.0, -2.0));
}

TEST(Boundaries, PrescribeEachNodeOnce) {
    const Loads loads = resolve_boundaries(mesh, {held("bottom", {}, 0.0), held("left", 0.0, 0.0)});
    EXPECT_EQ(loads.displacements.size(), 4U + 2U * 3U - 1U);  // the corner's u_y is shared
    EXPECT_TRUE(loads.edges.empty());
}

TEST(Boundaries, RefuseWhatMakesNoSense) {
    EXPECT_TRUE(mentions(refusal({traction_on("tpo", 1.0, 0.0)}), "available: bottom, left, right, top, point"));
    EXPECT_TRUE(mentions(refusal({held_at(1.1, 0.0, 0.0, 0.0)}), "the nearest is (1, 0)"));
    EXPECT_TRUE(mentions(refusal({held("bottom", 0.0, 0.0), held("left", 1.0, {})}), "boundary.1.displacement"));
    BoundarySection section = traction_on("top", 0.0, 1.0);
    section.force = Vec2(1.0, 0.0);
    EXPECT_TRUE(mentions(refusal({section}), "boundary.0.force"));
}

TEST(Boundaries, APressureTravelsAlongAnEdge) {
    Case input;
    input.boundaries = {test::under_wheel("some", {.p0 = 1.0, .half_width = 1.0, .from = 0.0, .to = 4.0})};
    Mesh with_set = mesh;
    with_set.node_sets["some"] = {0, 1};
    const auto refused = [&] { return test::refusal_of([&] { return resolve_loads(with_set, input); }); };
    EXPECT_TRUE(mentions(refused(), "boundary.0.travelling: a set of nodes without edges"));
    with_set.boundary["some"] = with_set.boundary.at("top");
    EXPECT_EQ(refused(), "accepted");
    with_set.boundary["some"].push_back(with_set.boundary.at("left").front());
    EXPECT_TRUE(mentions(refused(), "boundary.0.travelling: the edge is not straight"));
}

// A traction on an edge that is moved is borne by what moves it.
TEST(Boundaries, RefuseALoadThatTheSupportsBear) {
    const auto refused = [&](const std::vector<BoundarySection>& sections) {
        return test::refusal_of([&] { require_free_places(mesh, sections); });
    };
    BoundarySection pressed;
    pressed.on = "top";
    pressed.pressure = 5.0;
    EXPECT_TRUE(mentions(refused({held("top", {}, 0.0), traction_on("top", 0.0, 1.0)}), "boundary.1: its load acts"));
    EXPECT_TRUE(mentions(refused({pressed, held("top", {}, 1.0)}), "boundary.0: its load acts"));
    EXPECT_TRUE(mentions(refused({held("left", 0.0, 0.0), force_at(0.0, 0.0, 1.0, 0.0)}), "boundary.1: its load acts"));
    EXPECT_EQ(refused({held("top", 0.0, {}), traction_on("top", 0.0, 1.0)}), "accepted");
    EXPECT_EQ(refused({held("top", {}, 0.0), traction_on("top", 1.0, 1.0)}), "accepted") << "it is felt along x";
    EXPECT_EQ(refused({held("left", 0.0, 0.0), traction_on("top", 0.0, 1.0)}), "accepted")
        << "all but a corner is free";
}

TEST(RigidMotions, NothingIsFreeWhenTheSupportsSuffice) {
    const FreeMotions motions = motions_of({held("bottom", {}, 0.0), held_at(0.0, 0.0, 0.0, {})});
    EXPECT_TRUE(motions.names.empty());
    EXPECT_TRUE(motions.pins.empty());
    EXPECT_TRUE(motions.text.empty());
}

TEST(RigidMotions, ABalancedFreeBodyGetsThreePins) {
    const std::vector<BoundarySection> sections{traction_on("top", 0.0, 1.0), traction_on("bottom", 0.0, -1.0)};
    const FreeMotions motions = motions_of(sections);
    EXPECT_EQ(motions.names, (std::vector<std::string>{"translation along x", "translation along y", "rotation"}));
    EXPECT_EQ(motions.pins.size(), 3U);
    EXPECT_TRUE(holds_the_body(sections, motions));
    EXPECT_TRUE(mentions(motions.text, "removed without stress"));
}

TEST(RigidMotions, PinsOnlyWhatIsFree) {
    std::vector<BoundarySection> sections{traction_on("top", 0.0, 1.0), held("bottom", {}, 0.0)};
    FreeMotions motions = motions_of(sections);
    EXPECT_EQ(motions.names, std::vector<std::string>{"translation along x"});
    ASSERT_EQ(motions.pins.size(), 1U);
    EXPECT_EQ(motions.pins[0].component, 0);

    sections = {held_at(1.0, 2.0, 0.0, {})};  // turns about the point, and slides along y
    motions = motions_of(sections);
    EXPECT_EQ(motions.names, (std::vector<std::string>{"translation along y", "rotation"}));
    EXPECT_EQ(motions.pins.size(), 2U);
    EXPECT_TRUE(holds_the_body(sections, motions));
}

TEST(RigidMotions, NameTheMotionThatTheLoadsDrive) {
    EXPECT_TRUE(
        mentions(refusal({traction_on("top", 1.0, 0.0), traction_on("bottom", 0.0, 0.0)}), "translation along x"));
    EXPECT_TRUE(mentions(refusal({traction_on("top", 0.0, 1.0)}), "translation along y"));
    EXPECT_TRUE(mentions(refusal({traction_on("top", 0.0, 1.0), traction_on("bottom", 0.0, -0.98)}),
                         "along y free and the loads drive it by 0.08 N/mm, of 7.92 that act;"));
    EXPECT_TRUE(mentions(refusal({traction_on("top", 1.0, 0.0), traction_on("bottom", -1.0, 0.0)}), "rotation"));
    EXPECT_TRUE(mentions(refusal({held_at(0.0, 0.0, 0.0, 0.0), force_at(4.0, 0.0, 0.0, 1.0)}), "rotation"));
    EXPECT_EQ(refusal({held_at(0.0, 0.0, 0.0, 0.0), force_at(4.0, 0.0, 1.0, 0.0)}), "accepted");
    EXPECT_TRUE(mentions(refusal({held("left", 0.0, {}), force_at(4.0, 0.0, 0.0, 1e-6), force_at(4.0, 3.0, 1.0, 0.0)}),
                         "translation along y"));
}

TEST(LoadedBoundary, IsTheFirstThatCarriesSomething) {
    const auto boundary = loaded_among(mesh, {held("bottom", 0.0, 0.0), traction_on("top", 3.0, 4.0)});
    ASSERT_TRUE(boundary);
    EXPECT_EQ(boundary->name, "top");
    EXPECT_EQ(boundary->edges.size(), 3U);
    EXPECT_EQ(boundary->nodes, (std::vector<int>{8, 9, 10, 11}));
    EXPECT_LT((boundary->direction - Vec2(0.6, 0.8)).norm(), 1e-15);
    EXPECT_LT((boundary->resultant - Vec2(12.0, 16.0)).norm(), 1e-14);

    double mean = 0.0;  // of u_y = x
    for (const auto& [node, weight] : nodal_weights_of_mean(mesh, *boundary))
        mean += weight.y() * mesh.nodes[at(node)].x();
    EXPECT_NEAR(mean, 0.8 * 2.0, 1e-14);
}

TEST(LoadedBoundary, TakesItsDirectionFromWhatThereIs) {
    EXPECT_FALSE(loaded_among(mesh, {held("bottom", 0.0, 0.0)}));
    EXPECT_EQ(loaded_among(mesh, {held("top", {}, -0.1)})->direction, Vec2(0.0, -1.0));
    const auto point = loaded_among(mesh, {force_at(4.0, 3.0, 2.0, 0.0)});
    EXPECT_EQ(point->direction, Vec2(1.0, 0.0));
    EXPECT_EQ(point->nodes, std::vector<int>{11});
    BoundarySection bending;
    bending.on = "top";
    bending.origin = Vec2(2.0, 0.0);
    bending.traction_gradient << 0.0, 0.0, 1.0, 0.0;
    EXPECT_LT((loaded_among(mesh, {bending})->direction - Vec2(0.0, 1.0)).norm(), 1e-15);
    EXPECT_EQ(loaded_among(mesh, {bending})->resultant, Vec2(0.0, 0.0));
}

TEST(LoadedBoundary, BearsAllThatIsListedOnIt) {
    BoundarySection bending;
    bending.on = "top";
    bending.origin = Vec2(2.0, 0.0);
    bending.traction_gradient << 0.0, 0.0, 1.0, 0.0;
    const BoundarySection pulls = traction_on("top", 0.0, 1.0), down = traction_on("bottom", 0.0, -1.0);
    for (const std::vector<BoundarySection>& sections :
         {std::vector<BoundarySection>{pulls, pulls, down, down}, {bending, pulls, down, pulls, down}}) {
        const auto boundary = loaded_among(mesh, sections);
        EXPECT_LT((boundary->resultant - Vec2(0.0, 8.0)).norm(), 1e-14);
        EXPECT_LT((boundary->direction - Vec2(0.0, 1.0)).norm(), 1e-14);
        EXPECT_NEAR(boundary->pull, 8.0, 1e-14);
    }
    // One end in two parts.
    const auto half = loaded_among(mesh, {force_at(0.0, 3.0, 0.0, 2.0), force_at(4.0, 3.0, 0.0, 2.0), down});
    EXPECT_LT((half->resultant - Vec2(0.0, 2.0)).norm(), 1e-14);
    EXPECT_NEAR(half->pull, 4.0, 1e-14);
}

// Whatever the lengths of its edges, which refinement splits near a crack alone.
TEST(LoadedBoundary, OfAPressureAllAroundHasNoDirection) {
    BoundarySection around;
    around.on = "around";
    around.pressure = 1.0;
    Mesh whole = mesh;
    whole.nodes[11] = Vec2(5.0, 3.5);
    for (const auto& [name, edges] : mesh.boundary)
        whole.boundary["around"].insert(whole.boundary["around"].end(), edges.begin(), edges.end());
    const auto boundary = loaded_among(whole, {around});
    ASSERT_TRUE(boundary.has_value());
    EXPECT_FALSE(boundary->has_direction());
    EXPECT_EQ(boundary->resultant, Vec2(0.0, 0.0));
}

// A set of nodes without edges, as *NSET gives it.
TEST(BoundaryConditions, NodesWithoutEdgesAreHeldAndMoved) {
    Mesh with_set = mesh;
    with_set.node_sets["feet"] = {0, 2};
    const std::vector<BoundarySection> sections{held("feet", std::nullopt, 0.5)};
    const Loads loads = resolve_boundaries(with_set, sections);
    ASSERT_EQ(loads.displacements.size(), 2U);
    EXPECT_EQ(loads.displacements[1].node, 2);
    const auto boundary = loaded_among(with_set, sections);
    ASSERT_TRUE(boundary.has_value());
    for (const NodalWeight& weight : nodal_weights_of_mean(with_set, *boundary))
        EXPECT_EQ(weight.weight, Vec2(0.0, 0.5));
    EXPECT_THROW(resolve_boundaries(with_set, {traction_on("feet", 0.0, 1.0)}), CaseError);
}

}  // namespace
}  // namespace stria::coarse
