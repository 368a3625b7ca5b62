// Small plates of unit elements with a crack: their meshes, the zone they make, and displacements with a jump.
#pragma once

#include <algorithm>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "coarse/enrichment/enrichment.hpp"
#include "coarse/specimen/structured.hpp"
#include "coupling/messages.hpp"

namespace stria::test {

/// Steel that hardens, so that no tangent is singular; contact on every crack.
inline Case plate_case(std::vector<Vec2> crack, bool plastic = true) {
    Case input;
    input.material = {.young = 200e3, .poisson = 0.3, .yield_stress = {}, .isotropic = {}, .kinematic = {}};
    if (plastic) input.material.yield_stress = 300.0;
    if (plastic) input.material.kinematic = {{.C = 4000.0, .gamma = 0.0}};
    input.cracks.resize(1);
    input.cracks[0].points = std::move(crack);
    input.cracks[0].contact = ContactSection{};
    input.fine.substeps = 1;  // the tangent of several is made symmetric, and no exact derivative
    return input;
}

/// columns x rows unit elements, the lower left corner at (0, 0).
inline EnrichedMesh plate_mesh(int columns, int rows, const Case& input, int tip_functions = 1) {
    std::vector<double> xs, ys;
    for (int i = 0; i <= columns; ++i) xs.push_back(i);
    for (int i = 0; i <= rows; ++i) ys.push_back(i);
    return coarse::enrich(BodyMesh(coarse::grid_mesh(xs, ys)), input.cracks,
                          {.functions = tip_functions, .exponent = 0.5});
}

/// Two cracks, from the left and from the right, between whose rows a node hangs in the middle: its elements are those
/// of both once the tips are near it.
inline Case two_cracks(double left, double right, double width) {
    Case input = plate_case({{0.0, 5.5}, {left, 5.5}});
    input.cracks.push_back(input.cracks[0]);
    input.cracks[1].points = {{width, 2.5}, {right, 2.5}};
    return input;
}
inline EnrichedMesh with_hanging_node(EnrichedMesh mesh, const Vec2& place) {
    const auto node_at = [&](const Vec2& x) {
        const auto same = [&](const Vec2& node) { return (node - x).norm() < 1e-12; };
        return static_cast<int>(std::ranges::find_if(mesh.nodes, same) - mesh.nodes.begin());
    };
    const Vec2 edge(1.0, 0.0);
    mesh.tied = {{.node = node_at(place),
                  .ends = {node_at(place - edge), node_at(place + edge)},
                  .side = 1.0,
                  .jump_tied = false}};
    mesh.number();
    return mesh;
}

/// The whole plate as the zone: all unknowns of its outer nodes are shared.
inline coupling::Patch plate_patch(const EnrichedMesh& mesh) {
    coupling::Patch patch;
    patch.mesh = mesh;
    patch.displacement = patch.unit_load = Eigen::VectorXd::Zero(mesh.unknowns);
    const Vec2 corner = mesh.nodes.back();
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const Vec2& x = mesh.nodes[n];
        if (x.x() > 0.0 && x.y() > 0.0 && x.x() < corner.x() && x.y() < corner.y()) continue;
        const int terms = static_cast<int>(mesh.terms[n].size());
        for (int i = 0; i < 2 * (1 + terms); ++i) patch.boundary.push_back(mesh.first_unknown[n] + i);
    }
    return patch;
}

using Field = std::function<Vec2(const Vec2&)>;

/// Displacement `above` on the plus side and `below` on the minus side of a straight line that carries the crack; exact
/// for linear fields where the crack runs through the whole mesh.
inline Eigen::VectorXd two_sided(const EnrichedMesh& mesh, const Vec2& from, const Vec2& to, const Field& above,
                                 const Field& below) {
    const Vec2 normal(from.y() - to.y(), to.x() - from.x());
    Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.unknowns);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const Vec2& x = mesh.nodes[n];
        const Vec2 half_jump = 0.5 * (above(x) - below(x));
        const double side = !mesh.terms[n].empty()          ? mesh.terms[n][0].shift
                            : (x - from).dot(normal) >= 0.0 ? 1.0
                                                            : -1.0;
        u.segment<2>(mesh.unknown(static_cast<int>(n), 0, 0)) = 0.5 * (above(x) + below(x)) + side * half_jump;
        if (!mesh.terms[n].empty()) u.segment<2>(mesh.unknown(static_cast<int>(n), 1, 0)) = half_jump;
    }
    return u;
}

inline Eigen::VectorXd random_vector(Eigen::Index size, double amplitude, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
    return Eigen::VectorXd::NullaryExpr(size, [&] { return uniform(generator); });
}

}  // namespace stria::test
