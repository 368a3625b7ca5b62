// Elastic scenes put together by hand, for tests: no case file, no specimen.
#pragma once

#include "coarse/structure/structure.hpp"
#include "tests/support/cracked_mesh.hpp"

namespace stria::test {

inline const Elasticity steel{210e3, 0.3};

inline coarse::Scene make_scene(Mesh mesh, EnrichedMesh enriched, const Elasticity& elastic, coarse::Loads loads = {}) {
    coarse::Scene scene;
    scene.mesh = BodyMesh(std::move(mesh));
    scene.enriched = std::move(enriched);
    MaterialSection material;
    material.young = elastic.young;
    material.poisson = elastic.poisson;
    scene.materials = Materials(material, elastic.plane);
    scene.loads.main = std::move(loads);
    coarse::put_loads_on_unknowns(scene);
    return scene;
}

/// No fine zone: every element is the structure's.
inline ElementSet no_zone(const coarse::Scene& scene) { return ElementSet(scene.mesh->elements.size()); }

/// Displacement gradient of a homogeneous in-plane stress (the plane state gives the rest) without rotation.
inline Eigen::Matrix2d gradient_of(const Eigen::Matrix2d& stress, const Elasticity& elastic) {
    const double mu2 = 2.0 * elastic.shear_modulus();
    const double across = (3.0 - elastic.kolosov()) / 4.0;  // nu in plane strain, nu / (1 + nu) in plane stress
    return (stress - across * stress.trace() * Eigen::Matrix2d::Identity()) / mu2;
}

/// Nodal values of a linear field; enriched unknowns are zero.
inline Eigen::VectorXd linear_field(const EnrichedMesh& mesh, const Eigen::Matrix2d& gradient) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.unknowns);
    for (const auto& [node, term, unknown] : mesh.own_unknowns())
        if (term == 0) u.segment<2>(unknown) = gradient * mesh.nodes[at(node)];
    return u;
}

/// The tractions of a homogeneous stress on the whole boundary of a rectangle.
inline coarse::Loads boundary_tractions(const Mesh& mesh, const Eigen::Matrix2d& stress) {
    coarse::Loads loads;
    for (const auto& [name, edges] : mesh.boundary) {
        for (const BoundaryEdge& edge : edges) {
            const Vec2 outward = -coarse::edge_geometry(mesh, edge).inward_normal();
            loads.edges.push_back({edge, {.constant = stress * outward}});
        }
    }
    return loads;
}

inline std::vector<int> boundary_nodes(const Mesh& mesh) {
    std::vector<int> nodes;
    for (const auto& [name, edges] : mesh.boundary) {
        for (const BoundaryEdge& edge : edges)
            for (const int node : coarse::edge_nodes(mesh, edge)) nodes.push_back(node);
    }
    std::ranges::sort(nodes);
    nodes.erase(std::ranges::unique(nodes).begin(), nodes.end());
    return nodes;
}

}  // namespace stria::test
