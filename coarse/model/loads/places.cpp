#include "coarse/model/loads/places.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <string>

#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

int node_of_point(const Mesh& mesh, const Vec2& point, const std::string& key) {
    const int node = nearest_node(mesh, point);
    if (!is_at(mesh, node, point)) {
        const Vec2& nearest = mesh.nodes[at(node)];
        throw CaseError(fmt::format("{}.at: no mesh node at ({}, {}), the nearest is ({}, {})", key, point.x(),
                                    point.y(), nearest.x(), nearest.y()));
    }
    return node;
}

}  // namespace

std::string key_of(std::size_t section) { return fmt::format("boundary.{}", section); }

Vec2 displacement_of(const BoundarySection& section) {
    return {section.displacement[0].value_or(0.0), section.displacement[1].value_or(0.0)};
}

std::array<int, 2> edge_nodes(const Mesh& mesh, const BoundaryEdge& edge) {
    const auto& element = mesh.elements[at(edge.element)];
    const auto first = at(edge.edge);
    return {element[first], element[(first + 1) % 4]};
}

Place place_of(const Mesh& mesh, const BoundarySection& section, const std::string& key) {
    if (section.on == "point") return {{}, {node_of_point(mesh, section.at.value(), key)}, nullptr};
    if (const auto pin = mesh.pins.find(section.on); pin != mesh.pins.end()) {
        Place place{{}, {}, &pin->second};
        for (const SpreadPoint::Share& share : pin->second.shares) place.nodes.push_back(share.node);
        return place;
    }
    const auto edges = mesh.boundary.find(section.on);
    const auto set = mesh.node_sets.find(section.on);
    if (edges == mesh.boundary.end() && set == mesh.node_sets.end()) {
        std::set<std::string> names;
        for (const auto& [name, bounding] : mesh.boundary) names.insert(name);
        for (const auto& [name, pin] : mesh.pins) names.insert(name);
        for (const auto& [name, nodes] : mesh.node_sets) names.insert(name);
        throw CaseError(fmt::format("{}.on: \"{}\" is not a boundary of the mesh, available: {}, point", key,
                                    section.on, fmt::join(names, ", ")));
    }
    Place place{};
    std::set<int> nodes;
    if (edges != mesh.boundary.end()) place.edges = edges->second;
    for (const BoundaryEdge& edge : place.edges)
        for (const int node : edge_nodes(mesh, edge)) nodes.insert(node);
    if (set != mesh.node_sets.end()) nodes.insert(set->second.begin(), set->second.end());
    for (const HangingNode& hanging : mesh.hanging) nodes.erase(hanging.node);  // they follow their ends
    place.nodes.assign(nodes.begin(), nodes.end());
    return place;
}

}  // namespace stria::coarse
