#include "coarse/zone/zone_selection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coarse/model/rings.hpp"
#include "common/enrichment/part_of_mesh.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {}  // namespace

double subdivision_radius(double beta, double K_I, double yield_stress) {
    return beta * (std::numbers::pi / 16.0) * (K_I * K_I) / (yield_stress * yield_stress);
}

double zone_radius(const Case& input, double K_I) {
    if (input.fine.radius) return *input.fine.radius;
    if (!input.material.yield_stress) return 0.0;
    return subdivision_radius(input.fine.beta, std::max(K_I, 0.0), *input.material.yield_stress);
}

std::vector<char> select_zone(const Scene& scene, const std::vector<double>& K_I) {
    const EnrichedMesh& mesh = scene.enriched;
    std::vector<char> in_zone(mesh.elements.size(), 0);
    for (int e = 0; e < std::ssize(mesh.elements); ++e) in_zone[at(e)] = static_cast<char>(scene.mesh.is_split(e));
    for (const CrackPiece& piece : mesh.pieces) {
        if (!scene.input.cracks[at(piece.crack)].contact) continue;
        in_zone[at(piece.element)] = 1;
        if (piece.neighbour >= 0) in_zone[at(piece.neighbour)] = 1;
    }
    for (std::size_t t = 0; t < mesh.tips.size(); ++t) {
        const double radius = zone_radius(scene.input, K_I[t]);
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

std::vector<char> with_ring(const Scene& scene, std::vector<char> in_zone, const std::vector<int>& joining) {
    const auto around = elements_around_nodes(scene.mesh);
    for (const int element : joining) {
        for (const int node : scene.mesh.elements[at(element)]) {
            for (const int neighbour : around[at(node)])
                if (!scene.mesh.in_insert(neighbour)) in_zone[at(neighbour)] = 1;
        }
    }
    return in_zone;
}

std::vector<char> with_changed_functions(std::vector<char> in_zone, const EnrichedMesh& before,
                                         const EnrichedMesh& longer) {
    const std::vector<int> piece_before = piece_of_elements(before), piece = piece_of_elements(longer);
    const auto sees_tip = [&](int node) {
        const auto& terms = longer.terms[at(node)];
        return std::ranges::find(terms, Term::Kind::Tip, &Term::kind) != terms.end();
    };
    for (std::size_t e = 0; e < in_zone.size(); ++e)
        if ((piece_before[e] < 0 && piece[e] >= 0) || std::ranges::any_of(longer.elements[e], sees_tip)) in_zone[e] = 1;
    return in_zone;
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
    for (int t = 0; t < std::ssize(scene.enriched.tips); ++t) {
        const std::vector<Annulus> rings = rings_about(scene, t);
        for (int k = 0; k < std::ssize(rings); ++k) {
            const auto& [inner, outer] = rings[at(k)];
            if (reaches(patch.mesh, scene.enriched.tips[at(t)], rings[at(k)]))
                patch.rings.push_back({t, k, inner, outer});
        }
    }
    return patch;
}

}  // namespace stria::coarse
