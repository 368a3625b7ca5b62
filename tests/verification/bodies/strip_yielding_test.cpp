// Dugdale's strip in small-scale yielding: two rows of thin elements ahead of a tip are perfectly plastic in plane
// stress, all else is elastic (docs/references.md 3.4). In a thin strip between elastic halves the strain along it
// stays small, so that it transmits 2 / sqrt(3) of its yield stress. Four elements behind the tip yield too: elastic
// ones would hold the faces together there.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "coarse/model/mesh_refinement.hpp"
#include "common/fem/centre.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/exact_field.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

constexpr double strip_length = 0.01, metal_yields_at = 300.0, metal_young = 200e3, metal_poisson = 0.3;
const double transmitted = 2.0 / std::sqrt(3.0) * metal_yields_at;

double thickness(int levels) { return 1.0 / 16.0 / std::pow(2.0, levels); }  // of a row

double strip_K() { return transmitted * std::sqrt(8.0 * strip_length / std::numbers::pi); }

Case strip_case() {
    Case input;
    input.model.plane = PlaneState::Stress;
    input.material = {.young = metal_young,
                      .poisson = metal_poisson,
                      .yield_stress = metal_yields_at,
                      .isotropic = {},
                      .kinematic = {}};
    input.regions.resize(1);  // all but the strip
    input.regions[0].material = {
        .young = metal_young, .poisson = metal_poisson, .yield_stress = {}, .isotropic = {}, .kinematic = {}};
    input.cracks = {{.points = {{-0.5, 0.0}, {0.0, 0.0}}, .contact = {}}};
    input.fine.radius = 4.0 * strip_length;
    input.fine.enrichment = Enrichment::None;
    input.closure.distance = strip_length;
    input.load = {.steps = 16, .grading = 1.0, .blocks = {{.cycles = 0, .max = strip_K(), .min = 0.0}}};
    return input;
}

coarse::Scene strip_scene(const Case& input, int levels) {
    Mesh mesh = square_mesh(16);
    for (Vec2& x : mesh.nodes) x -= Vec2(0.5, 0.5);
    const Vec2 tip(0.0, 0.0), end(2.0 * strip_length, 0.0);
    coarse::Scene scene;
    scene.input = input;
    scene.materials = Materials(input);
    scene.mesh = coarse::refine(std::move(mesh), {{tip, end, 0.45, levels, 0.15}}).mesh;
    const double h = thickness(levels);
    scene.mesh.material.assign(scene.mesh.elements.size(), 1);
    for (int e = 0; e < std::ssize(scene.mesh.elements); ++e) {
        const Vec2 x = stria::centre(scene.mesh, e);
        if (std::abs(x.y()) < h && x.x() > -4.0 * h && x.x() < end.x()) scene.mesh.material[at(e)] = 0;
    }
    scene.enriched = coarse::enrich(scene.mesh, input.cracks, coarse::choose_enrichment(input));
    coarse::put_loads_on_unknowns(scene);
    impose(scene, 1);
    return scene;
}

/// Displacement across the crack's line of the node at a place, mm.
double across_at(const EnrichedMesh& mesh, const Eigen::VectorXd& u, const Vec2& place) {
    for (int n = 0; n < std::ssize(mesh.nodes); ++n)
        if ((mesh.nodes[at(n)] - place).norm() < 1e-9) return u[mesh.unknown(n, 0, 1)];
    throw std::out_of_range("no node there");
}

/// CTOD sigma / J and length sigma^2 / (E J).
struct Strip {
    double opening, length;
};

Strip strip_of(int levels) {
    const Case input = strip_case();
    const coarse::Scene scene = strip_scene(input, levels);
    fine::FineModel fine(input);
    coarse::CondensedFactory factory(&fine, input);
    EXPECT_EQ(run_analysis(factory, scene).cuts, 0);
    const coupling::ZoneState state = fine.state();
    const EnrichedMesh& mesh = fine.system().patch().mesh;
    const double h = thickness(levels), J = strip_K() * strip_K() / metal_young,
                 elastic = (1.0 - 0.5 * metal_poisson) * transmitted / metal_young * 2.0 * h,
                 opening = across_at(mesh, state.displacement, {0.0, h}) -
                           across_at(mesh, state.displacement, {0.0, -h}) - elastic;
    double stretched = 0.0;  // integral of the strip's opening along it, mm2: a third of CTOD times length
    for (std::size_t p = 0; p < state.x.size(); ++p) stretched += state.weight[p] * state.plastic_strain[4 * p + 1];
    return {opening * transmitted / J, 3.0 * stretched / opening * transmitted * transmitted / metal_young / J};
}

void expect_dugdale(const Strip& found, const std::string& mesh, double within) {
    const auto row = rows_of(
        {.scene = "strip yielding, small scale", .source = "Dugdale 1960 (3.4)", .within = within, .mesh = mesh});
    row("CTOD sigma / J", 1.0, found.opening);
    row("length sigma^2 / (E J)", std::numbers::pi / 8.0, found.length);
}

// The error is of first order in the thickness, as the next test shows: three rows' worth of the length.
TEST(StripYielding, HasTheLengthAndTheOpeningOfDugdale) {
    const double share = thickness(8) / strip_length;
    expect_dugdale(strip_of(8), fmt::format("{:.0f} elements of its length", 1.0 / share), 3.0 * share);
}

// What two thicknesses tend to; the square around is fifty times as large as the strip is long.
TEST(StripYielding, InfinitelyThinLong) {
    const Strip thin = strip_of(9), thinner = strip_of(10);
    const auto limit = [](double a, double b) { return 2.0 * b - a; };
    expect_dugdale({limit(thin.opening, thinner.opening), limit(thin.length, thinner.length)},
                   "82 and 164 elements of its length", 0.02);
    EXPECT_LT(std::abs(thinner.opening - 1.0), std::abs(thin.opening - 1.0));
    EXPECT_LT(std::abs(thinner.length - std::numbers::pi / 8.0), std::abs(thin.length - std::numbers::pi / 8.0));
}

}  // namespace
}  // namespace stria::test
