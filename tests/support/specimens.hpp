// Elastic specimens of width 1 under a unit load, solved: for comparisons with their handbooks.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <string>
#include <vector>

#include "coarse/elements/support_forces.hpp"
#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "common/index.hpp"

namespace stria::test {

constexpr double young = 200e3, poisson = 0.3, plane_modulus = young / (1.0 - poisson * poisson);

/// A name as gtest allows it.
inline std::string test_name(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
    return text;
}

/// Uniform traction | u_y imposed, u_x free | both components held.
enum class End { Pulled, Guided, Clamped };

inline BoundarySection at_end(const std::string& on, End end, double sign) {
    BoundarySection section;
    section.on = on;
    if (end == End::Pulled) section.traction = Vec2(0.0, sign);
    if (end != End::Pulled) section.displacement[1] = sign * 1e-3;
    if (end == End::Clamped) section.displacement[0] = 0.0;
    return section;
}

inline Case specimen(const std::string& name, double height, std::vector<Vec2> crack) {
    Case input;
    input.mesh = {.specimen = name, .width = 1.0, .height = height, .size = 1.0, .grading = {}};
    input.material.young = young;
    input.material.poisson = poisson;
    input.cracks = {{.points = std::move(crack), .contact = {}}};
    return input;
}

inline Case edge_crack(double a, double height, End end) {
    Case input = specimen("sent", height, {{0.0, height / 2.0}, {a, height / 2.0}});
    input.boundaries = {at_end("top", end, 1.0), at_end("bottom", end, -1.0)};
    return input;
}

/// `x` is the length of the crack over the width.
inline Case middle_crack(double x, double height) {
    Case input = specimen("mt", height, {{0.5 - x / 2.0, height / 2.0}, {0.5 + x / 2.0, height / 2.0}});
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    return input;
}

inline Case compact_tension(double a) {
    Case input = specimen("ct", 1.2, {{-0.25, 0.0}, {a, 0.0}});
    for (const double sign : {1.0, -1.0}) {
        BoundarySection pin;
        pin.on = sign > 0.0 ? "pin-top" : "pin-bottom";
        pin.force = Vec2(0.0, sign);
        input.boundaries.push_back(pin);
    }
    return input;
}

/// SE(B): three points at which it is held and loaded, four widths apart; the crack is opposite the load.
inline Case bent_bar(double a) {
    constexpr double overhang = 0.25, span = 4.0, height = span + 2.0 * overhang;
    Case input = specimen("plate", height, {{0.0, height / 2.0}, {a, height / 2.0}});
    input.boundaries.resize(3);
    for (BoundarySection& point : input.boundaries) point.on = "point";
    input.boundaries[0].at = Vec2(1.0, height / 2.0);
    input.boundaries[0].force = Vec2(-1.0, 0.0);
    input.boundaries[1].at = Vec2(0.0, overhang);
    input.boundaries[1].displacement = {0.0, 0.0};
    input.boundaries[2].at = Vec2(0.0, height - overhang);
    input.boundaries[2].displacement[0] = 0.0;
    return input;
}

/// 41 equal elements across.
inline Case uniform(Case input) {
    input.mesh.size = (input.mesh.specimen == "ct" ? 1.25 : 1.0) * input.mesh.width / 41.0;
    return input;
}

/// Elements of the size `at_tip` at every tip, growing away from it.
inline Case graded_to_tips(Case input, double at_tip = 0.01) {
    const std::string& name = input.mesh.specimen;
    input.mesh.size = (name == "ct" ? 1.25 / 20.0 : name == "sent" ? 1.0 / 20.0 : 1.0 / 14.0) * input.mesh.width;
    for (const CrackSection& crack : input.cracks) {
        for (const Vec2& end : crack.points) {
            if (end.x() == 0.0 || end.x() == -0.25) continue;  // a mouth
            input.mesh.grading.push_back({.at = {end},
                                          .size = at_tip,
                                          .outer_size = at_tip,
                                          .radius = 4.0 * at_tip,
                                          .growth = name == "mt" ? 0.4 : 0.25});
        }
    }
    return input;
}

/// With the functions of the scene, also where the nominal body has others.
struct ElasticSolution {
    coarse::Scene scene;
    coarse::NominalSolution nominal;
    const coarse::Structure& structure = *nominal.structure;
    const Eigen::VectorXd& u = nominal.fields.unit;
    const std::vector<coarse::TipResult>& tips = nominal.tips;

    explicit ElasticSolution(const Case& input)
        : scene(coarse::refined_scene(input)),
          nominal(coarse::solve_nominal(std::make_unique<coarse::Structure>(scene))) {}
    ElasticSolution(const ElasticSolution&) = delete;
    ElasticSolution& operator=(const ElasticSolution&) = delete;

    /// Force along y on a boundary whose displacement is imposed, N/mm.
    [[nodiscard]] double reaction(const std::string& boundary) const {
        const Eigen::VectorXd forces = coarse::forces_on_prescribed(structure.elements(), u);
        double sum = 0.0;
        NodeSet on_boundary(scene.mesh->nodes.size());
        for (const BoundaryEdge& edge : scene.mesh->boundary.at(boundary))
            for (const int node : coarse::edge_nodes(scene.mesh, edge)) on_boundary.insert(node);
        for (const int node : on_boundary.members()) {
            const int unknown = scene.enriched.unknown(node, 0, 1);
            const auto held =
                std::ranges::lower_bound(scene.prescribed, unknown, {}, &coarse::PrescribedUnknown::unknown);
            if (held != scene.prescribed.end() && held->unknown == unknown)
                sum += forces[held - scene.prescribed.begin()];
        }
        return sum;
    }

    [[nodiscard]] int elements_across() const { return static_cast<int>(scene.mesh->boundary.at("bottom").size()); }

    [[nodiscard]] double smallest_edge() const {
        double smallest = 1e300;
        for (const BoundaryEdge& edge : scene.mesh->boundary.at("bottom"))
            smallest = std::min(smallest, coarse::edge_geometry(scene.mesh, edge).length());
        return smallest;
    }
};

}  // namespace stria::test
