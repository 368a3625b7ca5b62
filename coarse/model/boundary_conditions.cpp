#include "coarse/model/boundary_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "common/error.hpp"
#include "common/fem/quadrature.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// What one section acts on: named edges, a single node, or a pin.
struct Place {
    std::vector<BoundaryEdge> edges;
    std::vector<int> nodes;  // ascending
    const SpreadPoint* pin;  // or null
};

const Vec2& node_at(const Mesh& mesh, int node) { return mesh.nodes[at(node)]; }

/// Shortest edge of the elements around a node: the scale on which a point is or is not that node.
double local_size(const Mesh& mesh, int node) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& element : mesh.elements) {
        if (std::find(element.begin(), element.end(), node) == element.end()) continue;
        for (std::size_t k = 0; k < 4; ++k) {
            shortest = std::min(shortest, (node_at(mesh, element[(k + 1) % 4]) - node_at(mesh, element[k])).norm());
        }
    }
    return shortest;
}

int node_of_point(const Mesh& mesh, const Vec2& point, const std::string& key) {
    constexpr double coincidence = 1e-6;
    if (!point.allFinite()) throw CaseError(key + ".at: the point is not finite");
    const auto nearest = std::min_element(mesh.nodes.begin(), mesh.nodes.end(), [&](const Vec2& a, const Vec2& b) {
        return (a - point).squaredNorm() < (b - point).squaredNorm();
    });
    const int node = static_cast<int>(nearest - mesh.nodes.begin());
    if ((*nearest - point).norm() > coincidence * local_size(mesh, node)) {
        throw CaseError(fmt::format("{}.at: no mesh node at ({}, {}), the nearest is ({}, {})", key, point.x(),
                                    point.y(), nearest->x(), nearest->y()));
    }
    return node;
}

Place place_of(const Mesh& mesh, const BoundarySection& section, const std::string& key) {
    if (section.on == "point") {
        if (!section.at) throw CaseError(key + ".at: on = \"point\" needs the point, at = [x, y]");
        return {{}, {node_of_point(mesh, *section.at, key)}, nullptr};
    }
    if (const auto pin = mesh.pins.find(section.on); pin != mesh.pins.end()) {
        Place place{{}, {}, &pin->second};
        for (const SpreadPoint::Share& share : pin->second.shares) place.nodes.push_back(share.node);
        return place;
    }
    if (const auto set = mesh.node_sets.find(section.on); set != mesh.node_sets.end())
        return {{}, set->second, nullptr};
    const auto found = mesh.boundary.find(section.on);
    if (found == mesh.boundary.end()) {
        std::string names;
        for (const auto& [name, edges] : mesh.boundary) names += name + ", ";
        for (const auto& [name, pin] : mesh.pins) names += name + ", ";
        for (const auto& [name, nodes] : mesh.node_sets) names += name + ", ";
        throw CaseError(
            fmt::format("{}.on: \"{}\" is not a boundary of the mesh, available: {}point", key, section.on, names));
    }
    std::set<int> nodes;
    for (const BoundaryEdge& edge : found->second) {
        for (const int node : edge_nodes(mesh, edge)) nodes.insert(node);
    }
    return {found->second, {nodes.begin(), nodes.end()}, nullptr};
}

Traction traction_of(const BoundarySection& section) {
    return {section.traction.value_or(Vec2::Zero()), section.traction_gradient, section.origin,
            section.pressure.value_or(0.0)};
}

/// The prescribed displacement, zero where it is free.
Vec2 displacement_of(const BoundarySection& section) {
    return {section.displacement[0].value_or(0.0), section.displacement[1].value_or(0.0)};
}

void validate(const Mesh& mesh, const BoundarySection& section, const std::string& key) {
    const bool on_point = section.on == "point", on_pin = mesh.pins.contains(section.on);
    const bool has_traction = section.traction || section.pressure || !section.traction_gradient.isZero(0.0);
    if ((on_point || on_pin) && has_traction)
        throw CaseError(key + ": a point or pin carries no traction or pressure, give it a force");
    if (mesh.node_sets.contains(section.on) && (has_traction || section.force))
        throw CaseError(key + ": a set of nodes without edges can be held or moved, and bears no load");
    if (on_pin && (section.displacement[0] || section.displacement[1]))
        throw CaseError(key + ".displacement: a pin turns freely and is not held, give it a force");
    if (!on_point && !on_pin && section.force)
        throw CaseError(key + ".force: only a point or pin carries a force, give an edge a traction");
    if (!on_point && section.at) throw CaseError(key + ".at: only with on = \"point\"");
    const Traction traction = traction_of(section);
    const bool finite = traction.constant.allFinite() && traction.gradient.allFinite() && traction.origin.allFinite() &&
                        std::isfinite(traction.pressure) && section.force.value_or(Vec2::Zero()).allFinite() &&
                        displacement_of(section).allFinite();
    if (!finite) throw CaseError(key + ": every value must be a finite number");
}

std::string key_of(std::size_t section) { return fmt::format("boundary[{}]", section + 1); }

using Prescribed = std::map<std::pair<int, int>, double>;

void prescribe(Prescribed& prescribed, const Mesh& mesh, const BoundarySection& section, int node,
               const std::string& key) {
    for (int component = 0; component < 2; ++component) {
        const std::optional<double>& value = section.displacement[at(component)];
        if (!value) continue;
        const auto [held, is_new] = prescribed.try_emplace({node, component}, *value);
        if (is_new || held->second == *value) continue;
        throw CaseError(fmt::format(
            "{}.displacement: u_{} = {} mm at the node ({}, {}), where another boundary prescribes "
            "{} mm",
            key, component == 0 ? 'x' : 'y', *value, node_at(mesh, node).x(), node_at(mesh, node).y(), held->second));
    }
}

}  // namespace

std::array<int, 2> edge_nodes(const Mesh& mesh, const BoundaryEdge& edge) {
    const auto& element = mesh.elements[at(edge.element)];
    const auto first = at(edge.edge);
    return {element[first], element[(first + 1) % 4]};
}

EdgeGeometry edge_geometry(const Mesh& mesh, const BoundaryEdge& edge) {
    const auto [from, to] = edge_nodes(mesh, edge);
    return {node_at(mesh, from), node_at(mesh, to)};
}

Loads resolve_boundaries(const Mesh& mesh, const std::vector<BoundarySection>& sections) {
    Loads loads;
    Prescribed prescribed;
    for (std::size_t k = 0; k < sections.size(); ++k) {
        const BoundarySection& section = sections[k];
        const Place place = place_of(mesh, section, key_of(k));
        validate(mesh, section, key_of(k));
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
        for (const int node : place.nodes) prescribe(prescribed, mesh, section, node, key_of(k));
    }
    for (const auto& [where, value] : prescribed) loads.displacements.push_back({where.first, where.second, value});
    return loads;
}

std::vector<AppliedForce> applied_forces(const Mesh& mesh, const Loads& loads) {
    std::vector<AppliedForce> forces;
    for (const auto& [edge, traction] : loads.edges) {
        const EdgeGeometry geometry = edge_geometry(mesh, edge);
        for (const LinePoint& point : gauss_line(2)) {
            const Vec2 x = geometry.at(0.5 * (1.0 + point.xi));
            const double length = 0.5 * point.weight * geometry.length();
            forces.push_back({x, length * traction.at(x, geometry.inward_normal())});
        }
    }
    for (const auto& [node, force] : loads.forces) forces.push_back({node_at(mesh, node), force});
    return forces;
}

std::optional<LoadedBoundary> loaded_boundary(const Mesh& mesh, const std::vector<BoundarySection>& sections) {
    for (std::size_t k = 0; k < sections.size(); ++k) {
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
        return LoadedBoundary{sections[k].on, place.edges, place.nodes, direction.normalized(), resultant};
    }
    return std::nullopt;
}

std::vector<NodalWeight> mean_displacement(const Mesh& mesh, const LoadedBoundary& boundary) {
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
