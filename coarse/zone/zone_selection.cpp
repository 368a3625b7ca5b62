#include "coarse/zone/zone_selection.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/fracture/plastic_zone.hpp"
#include "coarse/model/rings.hpp"
#include "common/case/case_questions.hpp"
#include "common/enrichment/part_of_mesh.hpp"
#include "common/fem/centre.hpp"
#include "common/fem/elements_about.hpp"
#include "common/index.hpp"
#include "common/integration/element_operator.hpp"
#include "common/memory.hpp"

namespace stria::coarse {
namespace {

/// Nodes of a mesh with terms of some kind.
template <class IsWanted> std::vector<int> nodes_with(const EnrichedMesh& mesh, const IsWanted& is_wanted) {
    std::vector<int> nodes;
    for (const int node : mesh.terms.nodes())
        if (std::ranges::any_of(mesh.terms[at(node)], is_wanted)) nodes.push_back(node);
    return nodes;
}

/// Unknowns of tip functions are the zone's own, however small the disk (full compression: none). A K that no ring
/// tells asks for none.
void add_disk(const Scene& scene, int t, double radius, ElementSet& zone) {
    const EnrichedMesh& mesh = scene.enriched;
    const Tip& tip = mesh.tips[at(t)];
    if (!(radius > 0.0) && !may_touch(scene.input.cracks[at(tip.crack)]) && !scene.materials.may_yield()) return;
    const auto is_of_tip = [&](const Term& term) { return term.kind == Term::Kind::Tip && term.owner == t; };
    for_each_about(scene.mesh, nodes_with(mesh, is_of_tip), [&](int e) {
        if (!scene.mesh->in_insert(e)) zone.insert(e);
    });
    if (!(radius >= 0.0)) return;
    const Vec2 reach = Vec2::Constant(radius);
    scene.mesh.visit_near({tip.position - reach, tip.position + reach}, [&](int e) {
        if ((centre(mesh, e) - tip.position).norm() <= radius && !scene.mesh->in_insert(e)) zone.insert(e);
    });
}

/// The force ahead of a tip is that of the zone's points: out to the distance, and no less than an element.
void add_sectors_ahead(const Scene& scene, std::vector<double> radii, ElementSet& zone) {
    if (!measures_tension(scene.input.closure)) return;
    const EnrichedMesh& mesh = scene.enriched;
    for (std::size_t t = 0; t < radii.size(); ++t) radii[t] = std::max(radii[t], tip_element_size(mesh, mesh.tips[t]));
    for (int e = 0; e < zone.size(); ++e) {
        const Vec2 middle = centre(mesh, e);
        const auto& corners = mesh.elements[at(e)];
        double reach = 0.0;
        for (const int node : corners) reach = std::max(reach, (mesh.nodes[at(node)] - middle).norm());
        for (std::size_t t = 0; t < mesh.tips.size(); ++t)
            if (!scene.mesh->in_insert(e) && (middle - mesh.tips[t].position).norm() <= radii[t] + reach)
                zone.insert(e);
    }
}

bool jumps(const EnrichedMesh& mesh, int node) {
    return std::ranges::any_of(mesh.terms[at(node)],
                               [](const Term& term) { return term.kind == Term::Kind::Heaviside; });
}

/// A piece along an edge needs both its elements on one side of the interface, and what jumps at its nodes jumps in all
/// elements about them: where it begins at a kink there are more than those beside it. So it does where a piece comes
/// through a node, and faces may touch: of a crack along a diagonal all multipliers stand at nodes. A jump that is not
/// the zone's own holds no multiplier.
void add_elements_that_jump(const Scene& scene, ElementSet& zone) {
    const EnrichedMesh& mesh = scene.enriched;
    std::vector<int> own;
    for (const CrackPiece& piece : mesh.pieces) {
        const bool along_edge = piece.neighbour >= 0;
        if (along_edge ? !(zone.contains(piece.element) || zone.contains(piece.neighbour))
                       : !may_touch(scene.input.cracks[at(piece.crack)]))
            continue;
        zone.insert(piece.element);
        if (along_edge) zone.insert(piece.neighbour);
        for (const double place : {piece.entry, piece.exit}) {
            if (place < 0.0 || place != std::floor(place)) continue;
            const int node = mesh.elements[at(piece.element)][at(static_cast<int>(place)) % 4];
            if (jumps(mesh, node)) own.push_back(node);
        }
    }
    for_each_about(scene.mesh, own, [&](int e) {
        if (!scene.mesh->in_insert(e)) zone.insert(e);
    });
}

}  // namespace

double zone_radius(const FineSection& fine, double yield_stress, double K) {
    if (fine.radius) return *fine.radius;
    return subdivision_radius(fine.beta, std::max(K, 0.0), yield_stress);
}

void add_touching_faces(const Scene& scene, ElementSet& elements) {
    for (const CrackPiece& piece : scene.enriched.pieces) {
        if (!may_touch(scene.input.cracks[at(piece.crack)])) continue;
        elements.insert(piece.element);
        if (piece.neighbour >= 0) elements.insert(piece.neighbour);
    }
}

ElementSet select_zone(const Scene& scene, const std::vector<double>& K) {
    ElementSet zone(scene.mesh->elements.size());
    for (int e = 0; e < zone.size(); ++e)
        if (scene.mesh->is_split(e)) zone.insert(e);
    add_touching_faces(scene, zone);
    const std::vector<double> yield_stress = scene.yield_stress_at_tips();
    for (int t = 0; t < std::ssize(scene.enriched.tips); ++t)
        add_disk(scene, t, zone_radius(scene.input.fine, yield_stress[at(t)], K[at(t)]), zone);
    add_sectors_ahead(scene, closure_distances(scene.input.closure, K, yield_stress), zone);
    add_elements_that_jump(scene, zone);
    const int subcells = subcells_elsewhere(scene.input.fine);
    const double elements = zone.count(), points = 4.0 * subcells * subcells * elements;
    require_memory(fmt::format("fine.subcells: a zone of {} points", points),
                   elements * bytes_of_zone_element + points * bytes_of_point);
    return zone;
}

std::vector<double> expected_K(std::vector<double> K) {
    for (double& of_tip : K) of_tip *= 1.02;
    return K;
}

ElementSet with_ring(const Scene& scene, ElementSet in_zone, const std::vector<int>& joining) {
    for (const int element : joining) {
        for (const int node : scene.mesh->elements[at(element)]) {
            for (const int neighbour : scene.mesh.around()[at(node)])
                if (!scene.mesh->in_insert(neighbour)) in_zone.insert(neighbour);
        }
    }
    return in_zone;
}

ElementSet with_changed_functions(ElementSet in_zone, const EnrichedMesh& before, const Scene& longer) {
    const std::vector<int> piece_before = piece_of_elements(before);
    for (const CrackPiece& piece : longer.enriched.pieces)
        if (piece.neighbour < 0 && piece_before[at(piece.element)] < 0) in_zone.insert(piece.element);
    const auto is_of_tip = [](const Term& term) { return term.kind == Term::Kind::Tip; };
    for_each_about(longer.mesh, nodes_with(longer.enriched, is_of_tip), [&](int e) { in_zone.insert(e); });
    return in_zone;
}

namespace {

/// Those of load cases on the zone's own unknowns, if there are any.
void put_case_loads(const Scene& scene, const std::vector<int>& whole, coupling::Patch& patch) {
    Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(patch.mesh.unknowns, std::ssize(scene.case_forces));
    for (std::size_t k = 0; k < scene.case_forces.size(); ++k)
        loads.col(static_cast<Eigen::Index>(k)) = gather(scene.case_forces[k], whole);
    for (const int i : patch.boundary) loads.row(i).setZero();
    if (!loads.isZero(0.0)) patch.case_loads = std::move(loads);
}

}  // namespace

ElementSet flowing_in(const ElementSet& zone, const std::vector<std::int32_t>& yielding_points) {
    ElementSet flowing(zone.size());
    if (yielding_points.empty()) return flowing;
    std::size_t place = 0;
    for (const int e : zone.members())
        if (yielding_points.at(place++) > 0) flowing.insert(e);
    return flowing;
}

coupling::Patch make_patch(const Scene& scene, const ElementSet& in_zone, const std::vector<int>& gamma,
                           const Eigen::VectorXd& displacement) {
    coupling::Patch patch;
    patch.mesh = extract(scene.enriched, in_zone.members());
    const std::vector<int> whole = whole_unknowns(scene.enriched, patch.mesh);
    patch.displacement.resize(patch.mesh.unknowns);
    patch.unit_load.resize(patch.mesh.unknowns);
    for (int i = 0; i < patch.mesh.unknowns; ++i) {
        patch.displacement[i] = displacement[whole[at(i)]];
        const bool shared = std::ranges::binary_search(gamma, whole[at(i)]);
        patch.unit_load[i] = shared ? 0.0 : scene.unit_force[whole[at(i)]];
        if (shared) patch.boundary.push_back(i);
    }
    put_case_loads(scene, whole, patch);
    for (int t = 0; t < std::ssize(scene.enriched.tips); ++t) {
        const std::vector<Annulus> rings = rings_about(scene, t);
        const double element = tip_element_edge(scene.enriched, scene.enriched.tips[at(t)]);
        for (int k = 0; k < std::ssize(rings); ++k) {
            const Annulus& ring = rings[at(k)];
            // An initial stress counts inside of a ring too, and another metal.
            if (scene.initial_stress().any() || !ring.one_metal ||
                reaches(patch.mesh, scene.enriched.tips[at(t)], ring))
                patch.rings.push_back({t, k, ring.inner, ring.outer, element});
        }
    }
    return patch;
}

}  // namespace stria::coarse
