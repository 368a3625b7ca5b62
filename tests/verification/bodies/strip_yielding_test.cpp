// Dugdale's strip in small-scale yielding: two rows of thin elements ahead of a tip are perfectly plastic in plane
// stress, all else is elastic (docs/references.md 3.4). In a thin strip between elastic halves the strain along it
// stays small, so that it transmits 2 / sqrt(3) of its yield stress. Four elements behind the tip yield too: elastic
// ones would hold the faces together there.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "common/fem/centre.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/exact_field.hpp"
#include "tests/support/refined_squares.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

constexpr double metal_yields_at = 300.0, metal_young = 200e3, metal_poisson = 0.3;
const double transmitted = 2.0 / std::sqrt(3.0) * metal_yields_at;

double thickness(int levels) { return 1.0 / 16.0 / std::pow(2.0, levels); }  // of a row

double strip_K(double length) { return transmitted * std::sqrt(8.0 * length / std::numbers::pi); }

Case strip_case(double length) {
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
    input.fine.radius = 4.0 * length;
    input.fine.enrichment = Enrichment::None;
    input.closure.distance = length;
    input.load = {.steps = 16, .grading = 1.0, .blocks = {{.cycles = 0, .max = strip_K(length), .min = 0.0}}};
    return input;
}

coarse::Scene strip_scene(const Case& input, double length, int levels) {
    Mesh mesh = square_mesh(16);
    for (Vec2& x : mesh.nodes) x -= Vec2(0.5, 0.5);
    const Vec2 tip(0.0, 0.0), end(2.0 * length, 0.0);
    coarse::Scene scene;
    scene.input = input;
    scene.materials = Materials(input);
    mesh = refined(mesh, {{tip, end, 0.45, levels, 0.15}}).mesh;
    const double h = thickness(levels);
    mesh.material.assign(mesh.elements.size(), 1);
    for (int e = 0; e < std::ssize(mesh.elements); ++e) {
        const Vec2 x = stria::centre(mesh, e);
        if (std::abs(x.y()) < h && x.x() > -4.0 * h && x.x() < end.x()) mesh.material[at(e)] = 0;
    }
    scene.mesh = BodyMesh(std::move(mesh));
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

Strip strip_of(double length, int levels) {
    const Case input = strip_case(length);
    const coarse::Scene scene = strip_scene(input, length, levels);
    fine::FineModel fine(input);
    coarse::CondensedFactory factory(&fine, input);
    EXPECT_EQ(run_analysis(factory, scene).cuts, 0);
    const coupling::ZoneState state = fine.state();
    const EnrichedMesh& mesh = fine.system().patch().mesh;
    const double h = thickness(levels), J = strip_K(length) * strip_K(length) / metal_young,
                 elastic = (1.0 - 0.5 * metal_poisson) * transmitted / metal_young * 2.0 * h,
                 opening = across_at(mesh, state.displacement, {0.0, h}) -
                           across_at(mesh, state.displacement, {0.0, -h}) - elastic;
    double stretched = 0.0;  // integral of the strip's opening along it, mm2: a third of CTOD times length
    for (std::size_t p = 0; p < state.x.size(); ++p) stretched += state.weight[p] * state.plastic_strain[4 * p + 1];
    return {opening * transmitted / J, 3.0 * stretched / opening * transmitted * transmitted / metal_young / J};
}

/// What is computed, and what it may be off by.
struct Bounded {
    double value, bound;
};

void expect_dugdale(const Bounded& opening, const Bounded& length, const std::string& mesh) {
    Comparison common{.scene = "strip yielding, small scale", .source = "Dugdale 1960 (3.4)", .mesh = mesh};
    common.within = opening.bound;
    rows_of(common)("CTOD sigma / J", 1.0, opening.value);
    common.within = length.bound / (std::numbers::pi / 8.0);
    rows_of(common)("length sigma^2 / (E J)", std::numbers::pi / 8.0, length.value);
}

constexpr double strip_length = 0.01;

// The error is of first order in the thickness, as the next test shows: three rows' worth of the length.
TEST(StripYielding, HasTheLengthAndTheOpeningOfDugdale) {
    const double share = thickness(8) / strip_length;
    const Strip found = strip_of(strip_length, 8);
    expect_dugdale({found.opening, 3.0 * share}, {found.length, 3.0 * share * std::numbers::pi / 8.0},
                   fmt::format("{:.0f} elements of its length", 1.0 / share));
}

// To a strip that is infinitely thin, by pairs of three thicknesses: what both limits differ by is the bound. The
// square around is fifty times as large as the strip is long. With half the strip and as many elements of its length it
// is twice as large, which takes half of the rest away: that half is the bound for what is left.
TEST(StripYielding, InfinitelyThinLong) {
    const std::array strips{strip_of(strip_length, 8), strip_of(strip_length, 9), strip_of(strip_length, 10)};
    const Strip shorter = strip_of(0.5 * strip_length, 9);
    const auto limit = [&](double Strip::*what) {
        const auto thin = [&](std::size_t k) { return 2.0 * strips[k + 1].*what - strips[k].*what; };
        const double size = shorter.*what - strips[0].*what;
        return Bounded{thin(1) + 2.0 * size, std::abs(thin(1) - thin(0)) + std::abs(size)};
    };
    expect_dugdale(limit(&Strip::opening), limit(&Strip::length), "41, 82 and 164 elements of its length");
}

}  // namespace
}  // namespace stria::test
