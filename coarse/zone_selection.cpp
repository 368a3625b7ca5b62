#include "coarse/zone_selection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/fem/domain_integral.hpp"

namespace stria::coarse {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

double distance_to_segment(const Vec2& x, const Vec2& a, const Vec2& b) {
    const double t = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (x - a - t * (b - a)).norm();
}

}  // namespace

double subdivision_radius(double beta, double K_I, double yield_stress) {
    return beta * (std::numbers::pi / 16.0) * (K_I * K_I) / (yield_stress * yield_stress);
}

std::vector<char> select_zone(const Scene& scene, const std::vector<double>& K_I) {
    const EnrichedMesh& mesh = scene.enriched;
    std::vector<char> in_zone(mesh.elements.size(), 0);
    for (const CrackPiece& piece : mesh.pieces) {
        if (!scene.input.cracks[at(piece.crack)].contact) continue;
        in_zone[at(piece.element)] = 1;
        if (piece.neighbour >= 0) in_zone[at(piece.neighbour)] = 1;
    }
    for (std::size_t t = 0; t < mesh.tips.size(); ++t) {
        double radius = scene.input.fine.radius.value_or(0.0);
        if (scene.input.material.yield_stress && !scene.input.fine.radius) {
            radius =
                subdivision_radius(scene.input.fine.beta, std::max(K_I[t], 0.0), *scene.input.material.yield_stress);
        }
        // Unknowns of tip functions are the zone's own, however small the disk (full compression: none).
        const bool touches = scene.input.cracks[at(mesh.tips[t].crack)].contact.has_value();
        if (radius <= 0.0 && !touches && !scene.input.material.yield_stress) continue;
        for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
            if (scene.mesh.in_insert(static_cast<int>(e))) continue;
            Vec2 centre = Vec2::Zero();
            bool tip_function = false;
            for (const int node : mesh.elements[e]) {
                centre += mesh.nodes[at(node)] / 4.0;
                tip_function = tip_function || std::ranges::any_of(mesh.terms[at(node)], [&](const Term& term) {
                                   return term.kind == Term::Kind::Tip && term.owner == static_cast<int>(t);
                               });
            }
            if (tip_function || (centre - mesh.tips[t].position).norm() <= radius) in_zone[e] = 1;
        }
    }
    // A piece along an edge needs both its elements on one side of the interface.
    for (const CrackPiece& piece : mesh.pieces) {
        if (piece.neighbour < 0) continue;
        const char either = static_cast<char>(in_zone[at(piece.element)] | in_zone[at(piece.neighbour)]);
        in_zone[at(piece.element)] = in_zone[at(piece.neighbour)] = either;
    }
    return in_zone;
}

std::vector<int> whole_unknowns(const EnrichedMesh& whole, const EnrichedMesh& part) {
    std::vector<int> result(at(part.unknowns));
    for (int n = 0; n < static_cast<int>(part.nodes.size()); ++n) {
        const int id = part.node_ids[at(n)];
        for (int t = 0; t <= static_cast<int>(part.terms[at(n)].size()); ++t) {
            // The part may have dropped terms that none of its elements sees.
            const int same = t == 0 ? 0 : whole.term_index(id, part.terms[at(n)][at(t - 1)]);
            for (int c = 0; c < 2; ++c) result[at(part.unknown(n, t, c))] = whole.unknown(id, same, c);
        }
    }
    return result;
}

double largest_ring(const Scene& scene, int tip_index) {
    const Tip& tip = scene.enriched.tips[at(tip_index)];
    double radius = 1e300;
    for (const auto& [name, edges] : scene.mesh.boundary) {
        for (const BoundaryEdge& edge : edges) {
            const EdgeGeometry ends = edge_geometry(scene.mesh, edge);
            radius = std::min(radius, distance_to_segment(tip.position, ends.from, ends.to));
        }
    }
    for (const PointForce& load : scene.loads.forces)
        radius = std::min(radius, (scene.mesh.nodes[at(load.node)] - tip.position).norm());
    for (std::size_t t = 0; t < scene.enriched.tips.size(); ++t) {
        if (at(tip_index) != t)
            radius = std::min(radius, (scene.enriched.tips[t].position - tip.position).norm() / 2.0);
    }
    // Other cracks, and this crack where it is not the straight end at the tip.
    for (int crack = 0; crack < static_cast<int>(scene.input.cracks.size()); ++crack) {
        const auto& points = scene.input.cracks[at(crack)].points;
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            const bool own = crack == tip.crack && (tip.upper > 0 ? k + 2 == points.size() : k == 0);
            const double d =
                own ? (points[k + 1] - points[k]).norm() : distance_to_segment(tip.position, points[k], points[k + 1]);
            radius = std::min(radius, d);
        }
    }
    return 0.95 * radius;
}

coupling::Patch make_patch(const Scene& scene, const std::vector<char>& in_zone, const std::vector<int>& gamma,
                           const Eigen::VectorXd& displacement) {
    std::vector<int> elements;
    for (int e = 0; e < static_cast<int>(in_zone.size()); ++e)
        if (in_zone[at(e)] != 0) elements.push_back(e);
    coupling::Patch patch;
    patch.mesh = extract(scene.enriched, elements);
    const std::vector<int> whole = whole_unknowns(scene.enriched, patch.mesh);
    patch.displacement.resize(patch.mesh.unknowns);
    patch.unit_load.resize(patch.mesh.unknowns);
    for (int i = 0; i < patch.mesh.unknowns; ++i) {
        patch.displacement[i] = displacement[whole[at(i)]];
        const bool shared = std::ranges::binary_search(gamma, whole[at(i)]);
        patch.unit_load[i] = shared ? 0.0 : scene.unit_force[whole[at(i)]];
        if (shared) patch.boundary.push_back(i);
    }
    for (int t = 0; t < static_cast<int>(scene.enriched.tips.size()); ++t) {
        const double outer = largest_ring(scene, t), inner = ring_inner_fraction * outer;
        const coupling::Ring ring{t, ring_weight(patch.mesh.nodes, scene.enriched.tips[at(t)], inner, outer), inner,
                                  outer};
        patch.j_rings.push_back(ring);
        patch.k_rings.push_back(ring);
    }
    return patch;
}

}  // namespace stria::coarse
