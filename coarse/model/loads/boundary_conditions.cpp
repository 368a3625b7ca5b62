#include "coarse/model/loads/boundary_conditions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "coarse/model/loads/places.hpp"
#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

const Vec2& node_at(const Mesh& mesh, int node) { return mesh.nodes[at(node)]; }

Traction traction_of(const BoundarySection& section) {
    Traction traction{section.traction.value_or(Vec2::Zero()), section.traction_gradient, section.origin,
                      section.pressure.value_or(0.0)};
    if (section.cosine) traction.cosine = {section.cosine->normalized(), section.centre};
    return traction;
}

/// What the mesh tells of a name and its kind: a set of nodes bears nothing, an edge no force.
void require_carrier(const Mesh& mesh, const BoundarySection& section, const std::string& key) {
    const bool of_nodes = mesh.node_sets.contains(section.on) && !mesh.boundary.contains(section.on);
    const bool has_traction = section.traction || section.pressure || !section.traction_gradient.isZero(0.0);
    if (of_nodes && (has_traction || section.force))
        throw CaseError(key + ": a set of nodes without edges can be held or moved, and bears no load");
    if (section.force && section.on != "point" && !mesh.pins.contains(section.on))
        throw CaseError(key + ".force: only a point or pin carries a force, give an edge a traction");
}

using Prescribed = std::map<std::pair<int, int>, double>;

void prescribe(Prescribed& prescribed, const Mesh& mesh, const BoundarySection& section, int node,
               const std::string& key) {
    for (int component = 0; component < 2; ++component) {
        const std::optional<double>& value = section.displacement[at(component)];
        if (!value) continue;
        const auto [held, is_new] = prescribed.try_emplace({node, component}, *value);
        if (is_new || held->second == *value) continue;
        throw CaseError(fmt::format(
            "{}.displacement: u_{} = {} mm at the node ({:.6g}, {:.6g}), where another boundary prescribes "
            "{} mm",
            key, component == 0 ? 'x' : 'y', *value, node_at(mesh, node).x(), node_at(mesh, node).y(), held->second));
    }
}

}  // namespace

EdgeGeometry edge_geometry(const Mesh& mesh, const BoundaryEdge& edge) {
    const auto [from, to] = edge_nodes(mesh, edge);
    return {node_at(mesh, from), node_at(mesh, to)};
}

Loads resolve_boundaries(const Mesh& mesh, const std::vector<BoundarySection>& sections,
                         const std::function<bool(const BoundarySection&)>& wanted) {
    Loads loads;
    Prescribed prescribed;
    for (std::size_t k = 0; k < sections.size(); ++k) {
        const BoundarySection& section = sections[k];
        if (!wanted(section)) continue;
        const Place place = place_of(mesh, section, key_of(k));
        require_carrier(mesh, section, key_of(k));
        const Traction traction = traction_of(section);
        if (!traction.is_zero()) {
            for (const BoundaryEdge& edge : place.edges) loads.edges.push_back({edge, traction});
        }
        if (section.force && place.pin != nullptr) {
            for (const auto& [node, weight] : place.pin->shares)
                loads.forces.push_back({node, weight * *section.force});
        } else if (section.force) {
            loads.forces.push_back({place.nodes.front(), *section.force});
        }
        if (place.edges.empty() && place.pin == nullptr)
            loads.points.insert(loads.points.end(), place.nodes.begin(), place.nodes.end());
        for (const int node : place.nodes) prescribe(prescribed, mesh, section, node, key_of(k));
    }
    for (const auto& [where, value] : prescribed) loads.displacements.push_back({where.first, where.second, value});
    return loads;
}

std::vector<AppliedForce> applied_forces(const Mesh& mesh, const Loads& loads) {
    std::vector<AppliedForce> forces;
    for (const auto& [edge, traction] : loads.edges) {
        const EdgeGeometry geometry = edge_geometry(mesh, edge);
        for (const auto& [fraction, length] : edge_points(traction, geometry, 0.0, 1.0, 2)) {
            const Vec2 x = geometry.at(fraction);
            forces.push_back({x, length * traction.at(x, geometry.inward_normal())});
        }
    }
    for (const auto& [node, force] : loads.forces) forces.push_back({node_at(mesh, node), force});
    return forces;
}

std::vector<NodalWeight> nodal_weights_of_mean(const Mesh& mesh, const LoadedBoundary& boundary) {
    std::vector<NodalWeight> sum;
    const auto add = [&](int node, double weight) { sum.push_back({node, weight * boundary.direction}); };
    if (const auto pin = mesh.pins.find(boundary.name); pin != mesh.pins.end()) {
        for (const auto& [node, share] : pin->second.shares) add(node, share);
        for (const auto& [node, share] : mesh.pins.at(pin->second.opposite).shares) add(node, -share);
        return sum;
    }
    if (boundary.edges.empty())
        for (const int node : boundary.nodes) add(node, 1.0 / static_cast<double>(boundary.nodes.size()));
    double length = 0.0;
    for (const BoundaryEdge& edge : boundary.edges) length += edge_geometry(mesh, edge).length();
    for (const BoundaryEdge& edge : boundary.edges) {
        for (const int node : edge_nodes(mesh, edge)) add(node, 0.5 * edge_geometry(mesh, edge).length() / length);
    }
    return sum;
}

}  // namespace stria::coarse
