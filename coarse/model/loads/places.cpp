#include "coarse/model/loads/places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

const Vec2& place_of_node(const Mesh& mesh, int node) { return mesh.nodes[at(node)]; }

/// Shortest edge of the elements around a node: the scale on which a point is or is not that node.
double local_size(const Mesh& mesh, int node) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& element : mesh.elements) {
        if (std::find(element.begin(), element.end(), node) == element.end()) continue;
        for (std::size_t k = 0; k < 4; ++k) {
            shortest = std::min(shortest,
                                (place_of_node(mesh, element[(k + 1) % 4]) - place_of_node(mesh, element[k])).norm());
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

}  // namespace

std::string key_of(std::size_t section) { return fmt::format("boundary[{}]", section + 1); }

Vec2 displacement_of(const BoundarySection& section) {
    return {section.displacement[0].value_or(0.0), section.displacement[1].value_or(0.0)};
}

std::array<int, 2> edge_nodes(const Mesh& mesh, const BoundaryEdge& edge) {
    const auto& element = mesh.elements[at(edge.element)];
    const auto first = at(edge.edge);
    return {element[first], element[(first + 1) % 4]};
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

}  // namespace stria::coarse
