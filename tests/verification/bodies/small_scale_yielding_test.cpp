// A tip in a power-law metal far from all else: the field of K on the boundary of a square, and elements halved towards
// the tip until they are 1e-4 of J / sigma_0. Near it the stress is that of Hutchinson, Rice and Rosengren
// (docs/references.md 3.1), with the J of its own place: with the flow theory J falls towards the tip (3.5).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/exact_field.hpp"
#include "tests/support/refined_squares.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

constexpr double reference_stress = 400.0, elastic_modulus = 200e3;  // MPa
constexpr double half_decade = 3.1622776601683795;

struct Hrr {
    PlaneState plane;
    double n, I, hoop;  // exponent, I_n, and hoop stress ahead of the tip
};

Case square_of(const Hrr& hrr) {
    Case input;
    input.model.plane = hrr.plane;
    input.material = {
        .young = elastic_modulus,
        .poisson = 0.3,
        .yield_stress = 0.1 * reference_stress,
        .isotropic = {.law = HardeningLaw::Power, .n = hrr.n, .alpha = 1.0, .reference = reference_stress},
        .kinematic = {}};
    input.cracks = {{.points = {{-0.5, 0.0}, {0.0, 0.0}}, .contact = {}}};
    input.fine.radius = 0.4;
    input.solver.tolerance = 1e-9;  // of all forces: those about the tip are a millionth of them and less
    // K of 0.12 sigma_0 sqrt(mm): on the boundary nothing yields.
    input.load = {.steps = 40, .grading = 1.0, .blocks = {{.cycles = 0, .max = 0.12 * reference_stress, .min = 0.0}}};
    return input;
}

struct Fineness {
    int across, levels;
    double growth;
};

coarse::Scene scene_of(const Case& input, const Fineness& fineness) {
    const Vec2 tip = input.cracks[0].points[1];
    Mesh square = square_mesh(fineness.across);
    for (Vec2& x : square.nodes) x -= Vec2(0.5, 0.5);
    coarse::Scene scene;
    scene.input = input;
    scene.materials = Materials(input);
    scene.mesh = BodyMesh(refined(std::move(square), {{tip, tip, 0.45, fineness.levels, fineness.growth}}).mesh);
    scene.enriched = coarse::enrich(scene.mesh, input.cracks, coarse::choose_enrichment(input));
    coarse::put_loads_on_unknowns(scene);
    impose(scene, 1);
    return scene;
}

/// Of the metal between a radius and twice it.
double J_about_tip(const fine::Bulk& bulk, double radius) {
    double J = 0.0;
    for (int e = 0; e < std::ssize(bulk.operators()); ++e) {
        const auto& points = bulk.operators()[at(e)].points;
        if (points[0].x.norm() < 0.5 * radius || points[0].x.norm() > 4.0 * radius) continue;
        const auto states = bulk.committed_states(e);
        for (std::size_t q = 0; q < points.size(); ++q) {
            const Vec2& x = points[q].x;
            if (x.norm() < radius || x.norm() > 2.0 * radius) continue;
            const Vec2 slope = -x / (x.norm() * radius);
            const auto& [s, work, gradient] = states[q];
            const double shear = s[3] / std::numbers::sqrt2;
            const Eigen::Matrix2d stress{{s[0], shear}, {shear, s[1]}};
            J += points[q].weight * ((stress * gradient.col(0)).dot(slope) - work * slope.x());
        }
    }
    return J;
}

/// Means over half a decade of r in a sector ahead of the tip, J there too; it is relative to that far away.
struct Reading {
    double stress, J_per_r, J;  // over sigma_0; J / r over sigma_0
};

Reading read_ahead(fine::FineModel& fine, double far_J, double from, double sector) {
    const coupling::ZoneState state = fine.state();
    const double unit = far_J / reference_stress;
    double count = 0.0, log_r = 0.0, log_stress = 0.0;
    for (std::size_t p = 0; p < state.x.size(); ++p) {
        const double r = std::hypot(state.x[p], state.y[p]) / unit;
        if (std::abs(state.y[p]) > sector * state.x[p] || r < from || r > half_decade * from) continue;
        count += 1.0, log_r += std::log(r), log_stress += std::log(state.stress[4 * p + 1] / reference_stress);
    }
    const double r = std::exp(log_r / count) * unit;
    const double J = J_about_tip(fine.system().bulk(), r / 1.5);  // a mean over its ring
    return {std::exp(log_stress / count), J / (reference_stress * r), J / far_J};
}

/// sigma_tt = sigma_0 (J E / (sigma_0^2 I r))^(1/(n+1)) hoop, alpha = 1.
double I_of(const Hrr& hrr, const Reading& reading) {
    return reading.J_per_r * elastic_modulus / reference_stress * std::pow(hrr.hoop / reading.stress, hrr.n + 1.0);
}

/// Of J / r, between two places.
double exponent_of(const Reading& near, const Reading& farther) {
    return std::log(near.stress / farther.stress) / std::log(near.J_per_r / farther.J_per_r);
}

/// What is left of a number at r = 0, and what it may be off by.
struct Limit {
    double value, bound;
};

/// Of readings half a decade apart, from the nearest one. Elastic strains are as r^((n-1)/(n+1)) beside those of the
/// power law, and so is what they change. But the next term of the field fades, too, at a rate that the readings tell:
/// what the limits by both rates differ by is the bound.
Limit limit_of(const std::array<double, 3>& nearest_first, double n) {
    const auto [near, farther, farthest] = nearest_first;
    const double elastic = std::pow(half_decade, -(n - 1.0) / (n + 1.0)), slowest = 0.9;
    const double seen = std::clamp((near - farther) / (farther - farthest), elastic, slowest);
    const auto beyond = [&](double rate) { return (near - farther) * rate / (1.0 - rate); };
    return {near + beyond(elastic), std::abs(beyond(seen) - beyond(elastic))};
}

struct Field {
    Limit exponent, I;
};

/// By half decades from the tip, in two sectors.
struct Readings {
    std::array<Reading, 4> wide, narrow;
};

Readings readings(const Case& input, const Fineness& fineness, double from) {
    const coarse::Scene scene = scene_of(input, fineness);
    fine::FineModel fine(input);
    coarse::CondensedFactory factory(&fine, input);
    const double far_J = run_analysis(factory, scene).increments.back().tips[0].J;
    Readings read{};
    for (std::size_t k = 0; k < 4; ++k, from *= half_decade) {
        read.wide[k] = read_ahead(fine, far_J, from, 0.15);
        read.narrow[k] = read_ahead(fine, far_J, from, 0.075);
    }
    return read;
}

/// The stress away from the line ahead is another one by the square of the angle: of two sectors, one half as wide, it
/// is taken off, and what was taken off counts as bound.
Field field_at_tip(const Hrr& hrr, const Fineness& fineness, double from) {
    const auto [wide, narrow] = readings(square_of(hrr), fineness, from);
    const auto limit = [&](const auto& number_at) {
        std::array<double, 3> ahead{};
        for (std::size_t k = 0; k < 3; ++k)
            ahead[k] = number_at(narrow, k) + (number_at(narrow, k) - number_at(wide, k)) / 3.0;
        const Limit found = limit_of(ahead, hrr.n);
        return Limit{found.value, found.bound + std::abs(ahead[0] - number_at(narrow, 0))};
    };
    return {limit([](const auto& all, std::size_t k) { return exponent_of(all[k], all[k + 1]); }),
            limit([&](const auto& all, std::size_t k) { return I_of(hrr, all[k]); })};
}

/// On two meshes, of which the coarser one's elements grow twice as fast with the distance from the tip. What the finer
/// one is off by is no more than both differ by; that and what the limit may be off by is what the row is held to.
void expect_field(const Hrr& hrr, const Fineness& fineness, double from) {
    const Fineness coarser{fineness.across, fineness.levels, 2.0 * fineness.growth};
    const Field found = field_at_tip(hrr, fineness, from), rough = field_at_tip(hrr, coarser, from);
    Comparison common{.scene = fmt::format("small-scale yielding, power law n = {}, {}", hrr.n,
                                           hrr.plane == PlaneState::Strain ? "plane strain" : "plane stress"),
                      .source = "Hutchinson 1968, Rice, Rosengren 1968 (3.1)",
                      .mesh =
                          fmt::format("{} x {}, halved {} times", fineness.across, fineness.across, fineness.levels)};
    const auto row = [&](const char* quantity, double reference, const Limit& ours, const Limit& coarse, double most) {
        common.within = (ours.bound + std::abs(ours.value - coarse.value)) / reference;
        rows_of(common)(quantity, reference, ours.value);
        EXPECT_LT(common.within, most) << quantity << ", n = " << hrr.n;  // else it would say nothing
    };
    row("exponent of the stress ahead of the tip", 1.0 / (hrr.n + 1.0), found.exponent, rough.exponent, 0.1);
    row("I_n, with J near the tip", hrr.I, found.I, rough.I, 0.02 * (hrr.n + 1.0));
}

TEST(SmallScaleYielding, TheStressNearTheTipLong) {
    for (const Hrr& hrr : {Hrr{PlaneState::Strain, 3.0, 5.5073, 1.9407},
                           {PlaneState::Strain, 5.0, 5.0235, 2.2171},
                           {PlaneState::Strain, 10.0, 4.5399, 2.4969},
                           {PlaneState::Stress, 3.0, 3.8550, 1.1061},
                           {PlaneState::Stress, 5.0, 3.4076, 1.1349},
                           {PlaneState::Stress, 10.0, 2.9788, 1.1473}})
        expect_field(hrr, {16, 24, 0.2}, 0.01 / half_decade);
}

// Without hardening J falls towards the tip, by "about 18 %": half a percent is the reference's own. Ours is held to
// that, to what it still falls by over the last half decade, and to what two meshes differ by.
TEST(SmallScaleYielding, JNearTheTipWithoutHardeningLong) {
    Case input = square_of({PlaneState::Strain, 1.0, 0.0, 0.0});
    input.material.yield_stress = reference_stress;
    input.material.isotropic = {};
    const auto near = [&](double growth) { return readings(input, {12, 17, growth}, 0.1).narrow; };
    const std::array<Reading, 4> found = near(0.25), rough = near(0.5);
    verify({.scene = "small-scale yielding without hardening, plane strain",
            .source = "Carka, Landis 2011 (3.5)",
            .quantity = "J near the tip over that far away",
            .reference = 0.82,
            .ours = found[0].J,
            .within = 0.005 + std::abs(found[0].J - found[1].J) + std::abs(found[0].J - rough[0].J),
            .mesh = "12 x 12, halved 17 times",
            .scale = 1.0});
}

}  // namespace
}  // namespace stria::test
