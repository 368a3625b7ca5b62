// Bodies with round edges, without a crack, beyond first yield: Hill's cylinder under pressure and a plate with a hole
// (docs/references.md 6.8 and 6.9).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "coarse/specimen/structured.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

using std::numbers::pi;

/// A quarter about the origin: the way from a circle to its outline at each angle, in `across` elements that grow by
/// `ratio` each, and `around` of them about.
template <class Outline>
Mesh quarter(double radius, const Outline& outline, int across, int around, double ratio = 1.0) {
    std::vector<double> shares{0.0};
    for (int k = 0; k < across; ++k) shares.push_back(shares.back() + std::pow(ratio, k));
    for (double& share : shares) share /= shares.back();
    shares.back() = 1.0;
    Mesh mesh = coarse::grid_mesh(shares, equal_cells(around));
    for (Vec2& x : mesh.nodes) {
        const double angle = 0.5 * pi * x.y(), share = x.x();
        // What the rounding of pi leaves must not move the axes.
        const Vec2 direction(x.y() == 1.0 ? 0.0 : std::cos(angle), x.y() == 0.0 ? 0.0 : std::sin(angle));
        x = (1.0 - share) * radius * direction + share * outline(direction);
    }
    return mesh;
}

BoundarySection held(const std::string& on, std::size_t component) {
    BoundarySection section;
    section.on = on;
    section.displacement[component] = 0.0;
    return section;
}

/// Symmetric about both axes, loaded to `largest` in equal increments.
Case quarter_case(double young, double poisson, double yield_stress, double largest, int increments) {
    Case input;
    input.mesh = {.specimen = "plate", .width = 1.0, .height = 1.0, .size = 1.0, .grading = {}};
    input.material = {
        .young = young, .poisson = poisson, .yield_stress = yield_stress, .isotropic = {}, .kinematic = {}};
    input.boundaries = {held("bottom", 1), held("top", 0)};
    input.load = {.steps = 2 * increments, .grading = 1.0, .blocks = {{.cycles = 0, .max = largest, .min = 0.0}}};
    return input;
}

/// At a node of the body that no zone holds, mm.
Vec2 displacement_at(const coarse::Scene& scene, const Followed& increment, const Vec2& place) {
    for (int n = 0; n < std::ssize(scene.mesh.nodes); ++n)
        if ((scene.mesh.nodes[at(n)] - place).norm() < 1e-9) {
            const int unknown = scene.enriched.unknown(n, 0, 0);
            return increment.displacement.segment<2>(unknown);
        }
    throw std::out_of_range("no node there");
}

// Of de Souza Neto, Peric and Owen; the displacement of the outer radius, for which Hill's closed form, which neglects
// elastic volume change where metal flows, is up to 0.45 % low.
TEST(CurvedBodies, HillsCylinderUnderPressure) {
    Case input = quarter_case(210e3, 0.3, 240.0, 180.0, 9);
    input.boundaries.emplace_back();
    input.boundaries.back().on = "left";
    input.boundaries.back().pressure = 1.0;
    const auto circle = [](const Vec2& direction) { return Vec2(200.0 * direction); };
    const coarse::Scene scene = coarse::make_scene(input, quarter(100.0, circle, 30, 30));
    const RunHistory run = run_direct(input, scene);
    for (const auto& [increment, displacement] :
         {std::pair(5, 0.057778), {6, 0.07042}, {7, 0.08729}, {8, 0.11164}, {9, 0.15402}})
        verify({.scene = fmt::format("Hill's cylinder, pressure {} MPa", 20 * increment),
                .source = "independent code, 8-node elements (6.8)",
                .quantity = "displacement of the outer radius, mm",
                .reference = displacement,
                .ours = displacement_at(scene, run.increments[at(increment - 1)], {200.0, 0.0}).x(),
                .within = 2e-3,
                .mesh = "30 x 30"});
}

// E. Stein and others (2002): 100 x 100 mm with a hole of 10 mm, perfectly plastic, at 0.855 of its limit load.
TEST(CurvedBodies, PlateWithAHole) {
    const double kappa = 164206.0, mu = 80193.8;
    Case input = quarter_case(9.0 * kappa * mu / (3.0 * kappa + mu),
                              (3.0 * kappa - 2.0 * mu) / (2.0 * (3.0 * kappa + mu)), 450.0, 400.0, 16);
    const auto square = [](const Vec2& direction) {
        return Vec2(100.0 * direction / direction.lpNorm<Eigen::Infinity>());
    };
    Mesh mesh = quarter(10.0, square, 40, 32, 1.08);
    for (const BoundaryEdge& edge : mesh.boundary.at("right"))
        if (coarse::edge_geometry(mesh, edge).inward_normal().y() < -0.5) mesh.boundary["loaded"].push_back(edge);
    input.boundaries.emplace_back();
    input.boundaries.back().on = "loaded";
    input.boundaries.back().traction = Vec2(0.0, 1.0);
    const coarse::Scene scene = coarse::make_scene(input, mesh);
    const Followed last = run_direct(input, scene).increments.back();
    const auto row = rows_of({.scene = "quarter of a plate with a hole, 400 MPa",
                              .source = "Stein and others 2002, independent code (6.9)",
                              .within = 2e-3,
                              .mesh = "40 x 32"});
    row("u_y at (0, 100), mm", 0.191286, displacement_at(scene, last, {0.0, 100.0}).y());
    row("u_x at (100, 100), mm", -0.065995, displacement_at(scene, last, {100.0, 100.0}).x());
    row("u_y at (100, 100), mm", 0.174062, displacement_at(scene, last, {100.0, 100.0}).y());
}

}  // namespace
}  // namespace stria::test
