// Bodies of several materials against what is known of them: patch tests, layers, an inclusion, a crack in one of two
// materials, and parts that never yield.
#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "coarse/model/rings.hpp"
#include "common/fem/centre.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/layered_plates.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

BoundarySection pulled(const char* on, const Vec2& traction) {
    BoundarySection section;
    section.on = on;
    section.traction = traction;
    return section;
}

/// E (1 - nu) / ((1 + nu) (1 - 2 nu)) in plane strain, E / (1 - nu^2) in plane stress: of a bar held at its sides.
double confined_modulus(const Elasticity& elastic) { return elastic.stiffness()(1, 1); }

/// Stress at the centre of the coarse element that holds a place, MPa.
Mandel stress_at(const ElasticSolution& solution, const Vec2& place) {
    Mandel stress = Mandel::Zero();
    double nearest = 1e300;
    solution.structure.elements().for_each([&](const auto& op) {
        const double distance = (centre(*solution.scene.mesh, op.element) - place).norm();
        if (distance >= nearest) return;
        nearest = distance;
        const auto local = gather(solution.u, op.unknowns);
        stress.setZero();
        for (std::size_t q = 0; q < op.points.size(); ++q)
            stress += op.points[q].weight / op.area * (solution.scene.stiffness(op.element) * op.strain(local, q));
    });
    return stress;
}

class LayersInSeries : public testing::TestWithParam<PlaneState> {};

/// Held at its sides and pressed by a quarter of its own weight, so to speak: piecewise linear, whatever the elements.
TEST_P(LayersInSeries, AreExact) {
    Case input = steel_plate(10.0, 12.0, 1.7);
    input.model.plane = GetParam();
    input.regions = {region_of({{-1.0, 0.0}, {11.0, 4.3}}, 70e3, 0.33),
                     region_of({{0.0, 8.0}, {10.0, 9.1}}, 5e3, 0.47)};
    input.boundaries = {moved("left", 0.0, {}), moved("right", 0.0, {}), moved("bottom", {}, 0.0),
                        pulled("top", {0.0, 100.0})};
    const ElasticSolution solution(input);
    const Materials& materials = solution.scene.materials;
    const auto exact = [&](double y) {
        double u = 0.0;
        const double ends[] = {0.0, 4.3, 8.0, 9.1, 12.0};
        const int layers[] = {1, 0, 2, 0};
        for (std::size_t k = 0; k < 4; ++k)
            u += 100.0 / confined_modulus(materials.elastic(layers[k])) *
                 std::clamp(y - ends[k], 0.0, ends[k + 1] - ends[k]);
        return u;
    };
    const double largest = exact(12.0);
    for (int n = 0; n < std::ssize(solution.scene.mesh->nodes); ++n) {
        const Vec2& x = solution.scene.mesh->nodes[at(n)];
        EXPECT_NEAR(solution.u[solution.scene.enriched.unknown(n, 0, 1)], exact(x.y()), 1e-11 * largest);
        EXPECT_NEAR(solution.u[solution.scene.enriched.unknown(n, 0, 0)], 0.0, 1e-11 * largest);
    }
}
INSTANTIATE_TEST_SUITE_P(PlaneStates, LayersInSeries, testing::Values(PlaneState::Strain, PlaneState::Stress),
                         [](const auto& test) { return test.param == PlaneState::Strain ? "strain" : "stress"; });

/// The same through the zone: a crack in one layer is pressed shut, and the faces bear what the bar bears.
TEST(SeveralMaterials, PressedFacesInALayerBearTheStressOfTheBar) {
    Case input = steel_plate(10.0, 12.0, 1.0);
    input.regions = {region_of({{0.0, 0.0}, {10.0, 4.5}}, 70e3, 0.33)};
    input.cracks = {{.points = {{-1.0, 7.6}, {11.0, 7.6}}, .contact = ContactSection{}}};
    input.boundaries = {moved("left", 0.0, {}), moved("right", 0.0, {}), moved("bottom", {}, 0.0),
                        pulled("top", {0.0, -100.0})};
    input.fine.radius = 1.0;
    input.solver.tolerance = 1e-11;
    coarse::Scene scene = coarse::refined_scene(input);
    const coarse::Structure structure(scene, ElementSet(scene.mesh->elements.size(), true));  // all is fine
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    fine::FineModel fine(scene.input);
    fine.set_patch(coarse::make_patch(scene, structure.in_zone(), structure.gamma(), zero));
    coarse::CondensedEquilibrium equilibrium(structure, &fine, scene.input, zero, 0.0);
    ASSERT_TRUE(coarse::find_equilibrium(equilibrium, {Control::Load, 1.0}, {}, {scene.input.solver}).converged);
    const coupling::StepReport report = equilibrium.commit({});
    ASSERT_FALSE(report.faces.empty());
    for (const coupling::FaceSample& face : report.faces) EXPECT_NEAR(face.pressure, 100.0, 1e-7);
    const coupling::ZoneState state = fine.state();
    for (std::size_t q = 0; q < state.element.size(); ++q) {
        EXPECT_NEAR(state.stress[4 * q + 1], -100.0, 1e-7);
        const double nu = state.y[q] < 4.5 ? 0.33 : 0.3;
        EXPECT_NEAR(state.stress[4 * q], -100.0 * nu / (1.0 - nu), 1e-7);
    }
}

/// Three layers side by side, bent by their ends: sigma_i = E_i kappa x away from the ends.
TEST(SeveralMaterials, ASandwichBendsLikeABeam) {
    Case input = steel_plate(4.0, 40.0, 0.25);
    input.model.plane = PlaneState::Stress;
    input.material = {.young = 10e3, .poisson = 0.0, .yield_stress = {}, .isotropic = {}, .kinematic = {}};
    input.regions = {region_of({{0.0, 0.0}, {1.0, 40.0}}, 200e3, 0.0),
                     region_of({{3.0, 0.0}, {4.0, 40.0}}, 200e3, 0.0)};
    for (const double side : {1.0, -1.0}) {
        BoundarySection end = pulled(side > 0.0 ? "top" : "bottom", Vec2::Zero());
        end.traction_gradient(1, 0) = side;
        end.origin = {2.0, 0.0};
        input.boundaries.push_back(end);
    }
    const ElasticSolution solution(input);
    const double moment = 64.0 / 12.0, inner = 8.0 / 12.0;  // I of the core; of the whole 64/12
    const double curvature = moment / (10e3 * inner + 200e3 * (64.0 / 12.0 - inner));
    for (const double x : {0.125, 0.875, 1.125, 1.875, 3.125, 3.875}) {
        const double E = x < 1.0 || x > 3.0 ? 200e3 : 10e3;
        verify({.scene = fmt::format("sandwich strip, bent, x = {}", x),
                .source = "beam theory",
                .quantity = "stress, MPa",
                .reference = E * curvature * (x - 2.0),
                .ours = stress_at(solution, {x, 20.125})[1],
                .within = 0.01,
                .mesh = "16 across",
                .scale = 200e3 * curvature * 2.0});
    }
}

/// A round inclusion in a wide plate under tension, by Goodier (1933): uniform stress inside. With polygons and
/// elements that have steps.
TEST(SeveralMaterials, ARoundInclusionBearsItsShare) {
    for (const double E : {600e3, 50e3}) {
        Case input = steel_plate(20.0, 20.0, 1.0);
        input.model.plane = PlaneState::Stress;
        input.mesh.grading = {{.at = {{10.0, 10.0}}, .size = 0.05, .outer_size = 0.05, .radius = 1.2, .growth = 0.15}};
        std::vector<Vec2> circle;
        for (int k = 0; k < 64; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / 64.0;
            circle.emplace_back(10.0 + std::cos(angle), 10.0 + std::sin(angle));
        }
        input.regions = {region_of(circle, E, 0.3)};
        input.boundaries = {pulled("top", {0.0, 1.0}), pulled("bottom", {0.0, -1.0})};
        const ElasticSolution solution(input);
        // Of Dundurs' parameters, the matrix first: sigma along and across the load inside.
        const double mu = 200e3 / 2.6, mu_i = E / 2.6, kappa = (3.0 - 0.3) / 1.3;
        const double bulk = mu_i * (kappa + 1.0) / (2.0 * mu_i + mu * (kappa - 1.0)) / 2.0;
        const double shear = mu_i * (kappa + 1.0) / (mu + mu_i * kappa) / 2.0;
        const Mandel inside = stress_at(solution, {10.0, 10.0});
        const auto row = rows_of({.scene = fmt::format("round inclusion, E = {:.0f} in 200 GPa", 1e-3 * E),
                                  .source = "Goodier 1933",
                                  .within = 0.02,
                                  .mesh = "radius / 20",
                                  .scale = bulk + shear});
        row("stress inside along the load / remote", bulk + shear, inside[1]);
        row("stress inside across the load / remote", bulk - shear, inside[0]);
    }
}

/// Edge crack in a stiff layer on a soft one: J, K^2 / E' of the layer that holds the tip, and the energy that a longer
/// crack releases.
TEST(SeveralMaterials, KOfACrackInOneOfTwoIsThatOfItsEnergyRelease) {
    const auto solve = [](double a) {
        Case input = graded_to_tips(edge_crack(a, 3.0, End::Pulled), 0.005);
        input.regions = {region_of({{0.6, -1.0}, {2.0, 4.0}}, 70e3, 0.33)};
        const ElasticSolution solution(input);
        return std::tuple(solution.tips[0], 0.5 * solution.scene.unit_force.dot(solution.u),
                          coarse::rings_about(solution.scene, 0).front().outer);
    };
    const double a = 0.4, step = 0.01;
    const auto [tip, energy, radius] = solve(a);
    EXPECT_LE(radius, 0.2);
    EXPECT_GT(radius, 0.18);
    EXPECT_NEAR(tip.K_I * tip.K_I / plane_modulus, tip.J, 3e-3 * tip.J);
    EXPECT_LT(tip.K_spread, 3e-3);
    EXPECT_GT(energy, 0.0);
    const double released = (std::get<1>(solve(a + step)) - std::get<1>(solve(a - step))) / (2.0 * step);
    EXPECT_NEAR(released, tip.J, 0.01 * tip.J);
    // The same the other way round: the tip lies in the region.
    Case other = graded_to_tips(edge_crack(a, 3.0, End::Pulled), 0.005);
    other.regions = {region_of({{-1.0, -1.0}, {0.6, 4.0}}, young, poisson)};
    other.material.young = 70e3;
    other.material.poisson = 0.33;
    EXPECT_NEAR(ElasticSolution(other).tips[0].K_I, tip.K_I, 1e-9 * tip.K_I);
    const ElasticSolution alone(graded_to_tips(edge_crack(a, 3.0, End::Pulled), 0.005));
    EXPECT_GT(tip.K_I, 1.1 * alone.tips[0].K_I);  // the soft layer gives way
}

/// A strip that never yields beside one that does: what it bears grows on, what the other bears stays.
TEST(SeveralMaterials, AnInsertNeverYields) {
    Case input = steel_plate(4.0, 6.0, 1.0);
    input.model.plane = PlaneState::Stress;
    input.material.yield_stress = 300.0;
    input.material.poisson = 0.0;
    input.regions = {region_of({{3.0, 0.0}, {4.0, 6.0}}, 200e3, 0.0)};
    input.cracks = {{.points = {{-1.0, 3.2}, {5.0, 3.2}}, .contact = ContactSection{}}};  // pressed: it brings a zone
    input.boundaries = {moved("bottom", {}, 0.0), moved("top", {}, -1.0)};
    for (const double y : {0.0, 6.0}) {  // the halves would slide on each other
        input.boundaries.push_back(moved("point", 0.0, {}));
        input.boundaries.back().at = Vec2(0.0, y);
    }
    input.load = {.steps = 8, .blocks = {{.cycles = 0, .max = 0.024, .min = 0.0}}};
    input.solver.tolerance = 1e-8;
    const RunHistory history = run_direct(input);
    const Followed& last = history.increments.back();
    const double strain = 0.024 / 6.0;
    EXPECT_NEAR(last.machine.force, 3.0 * 300.0 + 1.0 * 200e3 * strain, 1e-6 * 1700.0);
    EXPECT_GT(history.extensions, 0);
    // 3 mm x 6 mm yield from 300/E on; nothing else dissipates.
    EXPECT_NEAR(last.work.dissipated, 18.0 * 300.0 * (strain - 300.0 / 200e3), 1e-6 * 18.0);
}

/// Pulled by 150 MPa; the upper part has a yield stress of its own.
Case pulled_two(double lower, double upper) {
    Case input = steel_plate(20.0, 40.0, 1.0);
    input.material.yield_stress = lower;
    input.regions = {region_of({{0.0, 30.0}, {20.0, 40.0}}, 200e3, 0.3)};
    input.regions[0].material.yield_stress = upper;
    input.regions[0].material.isotropic.modulus = 20e3;
    input.cracks = {{.points = {{8.2, 15.3}, {12.7, 15.3}}, .contact = {}}};
    input.boundaries = {pulled("top", {0.0, 1.0}), pulled("bottom", {0.0, -1.0})};
    input.fine.radius = 6.0;
    input.load = {.steps = 4, .blocks = {{.cycles = 0, .max = 150.0, .min = 0.0}}};
    return input;
}

/// Where the weaker of two materials yields first, far from any tip, the guard looks at each with its own yield stress.
TEST(SeveralMaterials, TheGuardKnowsWhereAnElementIs) {
    Case input = pulled_two(300.0, 100.0);
    const RunHistory history = run_direct(input);
    EXPECT_GT(history.extensions, 0);
    // A quarter of 800 elements yields, and a disk of 113 mm2 is fine from the start: 16 points each.
    EXPECT_LT(history.increments.back().zone.points, 500 * 16);
    EXPECT_EQ(run_direct(pulled_two(300.0, 300.0)).extensions, 0);
}

}  // namespace
}  // namespace stria::test
