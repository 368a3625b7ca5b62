// The exact singular fields as displacement data on the boundary of a unit square with a crack to its middle.
#pragma once

#include <algorithm>
#include <vector>

#include "common/fracture/williams.hpp"
#include "tests/support/elastic_scene.hpp"

namespace stria::test {

const Elasticity unit{1.0, 0.3};

/// Holds every boundary unknown at the exact field: standard ones at the nodes, and the jump of either side's field
/// continued to the node.
inline void impose(coarse::Scene& scene, int mode) {
    const EnrichedMesh& mesh = scene.enriched;
    const auto exact = [&](const Vec2& x, int side) {
        return williams_field(mode, mesh.tips.front(), x, side, scene.materials.elastic(0)).displacement;
    };
    std::vector<coarse::PrescribedUnknown> held;
    for (const int node : boundary_nodes(scene.mesh)) {
        const Vec2& x = mesh.nodes[at(node)];
        const Vec2 u = exact(x, 0), half_jump = (exact(x, 1) - exact(x, -1)) / 2.0;
        for (int c = 0; c < 2; ++c) {
            held.push_back({mesh.unknown(node, 0, c), u[c]});
            if (heaviside_side(mesh, node) != 0.0) held.push_back({mesh.unknown(node, 1, c), half_jump[c]});
        }
    }
    std::ranges::sort(held, {}, &coarse::PrescribedUnknown::unknown);
    scene.prescribed = held;
    scene.pull = Eigen::VectorXd::Zero(std::ssize(held));
}

struct Setting {
    coarse::TipEnrichment tips;
    int mode;
    bool along_edges;  // or through the middle of the elements
};

inline coarse::Scene exact_boundary(int n, const Setting& setting) {
    const Mesh mesh = coarse::grid_mesh(equal_cells(n), equal_cells(setting.along_edges ? n + 1 : n));
    const std::vector<Vec2> crack{{0.0, 0.5}, {0.5, 0.5}};
    coarse::Scene scene = make_scene(mesh, cracked(mesh, crack, setting.tips), unit);
    scene.input.cracks = {{.points = crack, .contact = {}}};
    impose(scene, setting.mode);
    return scene;
}

/// Of a displacement, in the energy norm over that of the exact field.
inline double energy_error(const coarse::Structure& structure, const Eigen::VectorXd& u, int mode) {
    const coarse::Scene& scene = structure.scene();
    double wrong = 0.0, whole = 0.0;
    structure.elements().for_each([&](const auto& op) {
        const auto local = gather(u, op.unknowns);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const IntegrationPoint& point = op.points[q];
            const TipField exact =
                williams_field(mode, scene.enriched.tips[0], point.x, point.side, scene.materials.elastic(0));
            const Mandel strain = strain_of(exact.gradient), difference = op.strain(local, q) - strain;
            wrong += point.weight * difference.dot(scene.materials.elastic(0).stiffness() * difference);
            whole += point.weight * strain.dot(scene.materials.elastic(0).stiffness() * strain);
        }
    });
    return std::sqrt(wrong / whole);
}

}  // namespace stria::test
