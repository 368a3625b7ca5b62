#include "coarse/model/loads/loads_of_case.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coarse/load/case_histories.hpp"
#include "common/case/loads/load_case_checks.hpp"
#include "common/error.hpp"

namespace stria::coarse {
namespace {

/// Places along an edge need one direction.
void require_straight(const Mesh& mesh, const std::vector<BoundaryEdge>& edges, const std::string& key) {
    const Vec2 normal = edge_geometry(mesh, edges.front()).inward_normal();
    for (const BoundaryEdge& edge : edges)
        if ((edge_geometry(mesh, edge).inward_normal() - normal).norm() > 1e-6)
            throw CaseError(key + ".travelling: the edge is not straight");
}

/// One for each position.
void add_travelling(const Mesh& mesh, const BoundarySection& section, const std::string& key, int positions,
                    std::vector<Loads>& cases) {
    const TravellingPressure& travelling = *section.travelling;
    const Place place = place_of(mesh, section, key);
    require_straight(mesh, place.edges, key);
    for (int k = 0; k < positions; ++k) {
        const double middle = std::lerp(travelling.from, travelling.to, static_cast<double>(k) / (positions - 1));
        Traction traction{.origin = section.origin};
        traction.hertz = {travelling.p0, travelling.half_width, middle, travelling.friction};
        Loads& loads = cases.emplace_back();
        for (const BoundaryEdge& edge : place.edges) loads.edges.push_back({edge, traction});
    }
}

/// What load cases move is held where they are without load.
void hold_what_moves(LoadsOfCase& loads) {
    std::vector<PrescribedDisplacement>& held = loads.main.displacements;
    const auto place = [](const PrescribedDisplacement& d) { return std::pair(d.node, d.component); };
    for (const Loads& of_case : loads.cases) {
        for (const PrescribedDisplacement& d : of_case.displacements) {
            const auto found = std::ranges::lower_bound(held, place(d), {}, place);
            if (found == held.end() || place(*found) != place(d)) held.insert(found, {d.node, d.component, 0.0});
        }
    }
}

}  // namespace

LoadsOfCase resolve_loads(const Mesh& mesh, const Case& input) {
    LoadsOfCase loads{resolve_boundaries(mesh, input.boundaries, is_of_main_load), {}};
    for (const LoadCaseSection& load_case : input.load_cases)
        loads.cases.push_back(resolve_boundaries(mesh, input.boundaries, [&](const BoundarySection& section) {
            return section.load_case == load_case.name;
        }));
    for (std::size_t k = 0; k < input.boundaries.size(); ++k)
        if (input.boundaries[k].travelling)
            add_travelling(mesh, input.boundaries[k], key_of(k), positions_of_travel(input.load), loads.cases);
    hold_what_moves(loads);
    return loads;
}

namespace {

/// Of a load case on the boundary that is looked at.
Vec2 resultant_on(const Mesh& mesh, const LoadedBoundary& boundary, const Loads& loads) {
    const auto same = [](const BoundaryEdge& a, const BoundaryEdge& b) {
        return a.element == b.element && a.edge == b.edge;
    };
    Loads there;
    for (const EdgeLoad& load : loads.edges)
        if (std::ranges::any_of(boundary.edges, [&](const BoundaryEdge& edge) { return same(edge, load.edge); }))
            there.edges.push_back(load);
    for (const PointForce& load : loads.forces)
        if (std::ranges::binary_search(boundary.nodes, load.node)) there.forces.push_back(load);
    Vec2 resultant = Vec2::Zero();
    for (const AppliedForce& applied : applied_forces(mesh, there)) resultant += applied.force;
    return resultant;
}

std::optional<LoadedBoundary> first_loaded(const Mesh& mesh, const std::vector<BoundarySection>& sections,
                                           const std::function<bool(const BoundarySection&)>& wanted) {
    for (std::size_t k = 0; k < sections.size(); ++k) {
        if (!wanted(sections[k])) continue;
        const Loads loads = resolve_boundaries(mesh, {sections[k]});
        const Vec2 displacement = displacement_of(sections[k]);
        Vec2 resultant = Vec2::Zero(), normal = Vec2::Zero();
        double magnitude = 0.0;
        for (const AppliedForce& applied : applied_forces(mesh, loads)) {
            resultant += applied.force;
            magnitude += applied.force.norm();
        }
        if (magnitude == 0.0 && displacement.isZero(0.0)) continue;

        const Place place = place_of(mesh, sections[k], key_of(k));
        for (const BoundaryEdge& edge : place.edges) normal -= edge_geometry(mesh, edge).inward_normal();
        // Pure bending has no resultant: its direction is then the boundary's outward normal.
        const bool balanced = resultant.norm() <= 1e-9 * magnitude;
        const Vec2 direction = !displacement.isZero(0.0) ? displacement : balanced ? normal : resultant;
        return LoadedBoundary{sections[k].on,         place.edges, place.nodes,
                              direction.normalized(), resultant,   !resultant.isZero(0.0)};
    }
    return std::nullopt;
}

}  // namespace

std::optional<LoadedBoundary> loaded_boundary(const Mesh& mesh, const Case& input) {
    std::optional<LoadedBoundary> loaded = first_loaded(mesh, input.boundaries, is_of_main_load);
    if (!loaded) {
        loaded = first_loaded(mesh, input.boundaries,
                              [](const BoundarySection& section) { return section.load_case.has_value(); });
        if (loaded) loaded->resultant.setZero();  // of the main load
    }
    if (loaded)
        for (const Loads& loads : resolve_loads(mesh, input).cases)
            loaded->in_cases.push_back(resultant_on(mesh, *loaded, loads));
    return loaded;
}

}  // namespace stria::coarse
