#include "coarse/specimen/compact_tension.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "coarse/specimen/structured.hpp"
#include "common/fem/centre.hpp"
#include "common/geometry/vec2.hpp"
#include "common/index.hpp"
#include "common/index_set.hpp"

namespace stria::coarse {
namespace {

// Over W.
constexpr double front = 0.25, half_height = 0.6, hole_height = 0.275, hole_radius = 0.125, insert_radius = 0.2;
/// The pin touches its hole over an arc of twice this. Newman's compliances, which the standards took over, are met for
/// 15 to 45 degrees; with a filled hole the front face would open by 4 P / (E' B) less at any crack length.
constexpr double contact_angle = std::numbers::pi / 6.0;

/// The sector of the hole through which the pin presses outwards: elements whose middle is in it; on a mesh too coarse
/// for that, the nearest.
std::vector<int> pin_elements(const Mesh& mesh, const Vec2& pin, double radius) {
    std::vector<int> inside;
    int nearest = 0;
    for (int element = 0; element < static_cast<int>(mesh.elements.size()); ++element) {
        const Vec2 middle = centre(mesh, element);
        const double distance = (middle - pin).norm();
        const double angle = std::atan2(std::abs(middle.x()), std::abs(middle.y()) - std::abs(pin.y()));
        if (distance <= radius && angle <= contact_angle) inside.push_back(element);
        if (distance < (centre(mesh, nearest) - pin).norm()) nearest = element;
    }
    if (inside.empty()) inside.push_back(nearest);
    return inside;
}

/// Each rectangle's area to its corners, then weighted linearly in x so that a force along y acts on the load line.
SpreadPoint spread_over(const Mesh& mesh, const std::vector<int>& elements, const Vec2& pin) {
    std::map<int, double> area;
    for (const int element : elements) {
        const auto& nodes = mesh.elements[at(element)];
        const Vec2 extent = mesh.nodes[at(nodes[2])] - mesh.nodes[at(nodes[0])];
        for (const int node : nodes) area[node] += 0.25 * extent.x() * extent.y();
    }
    const auto moments = [&](int node) {
        const Vec2 arm = mesh.nodes[at(node)] - pin;
        return Vec2(1.0, arm.x());
    };
    Eigen::Matrix2d gram = Eigen::Matrix2d::Zero();
    for (const auto& [node, share] : area) gram += share * moments(node) * moments(node).transpose();
    const Vec2 linear = gram.inverse() * Vec2::UnitX();
    SpreadPoint result;
    for (const auto& [node, share] : area) result.shares.push_back({node, share * linear.dot(moments(node))});
    return result;
}

/// Nearest pin's middle.
Vec2 pin_near(const Vec2& x, double width) { return {0.0, std::copysign(hole_height * width, x.y())}; }

/// The elements of the holes that no pin fills.
ElementSet open_holes(const Mesh& mesh, const std::vector<int>& pins, double width) {
    ElementSet open(mesh.elements.size());
    for (int element = 0; element < open.size(); ++element) {
        const Vec2 middle = centre(mesh, element);
        const bool in_hole = (middle - pin_near(middle, width)).norm() <= hole_radius * width;
        if (in_hole && !std::ranges::binary_search(pins, element)) open.insert(element);
    }
    return open;
}

/// Edges of elements beside a hole: boundaries "hole-top" and "hole-bottom".
void name_hole_edges(Mesh& mesh, const ElementSet& open) {
    std::map<std::pair<int, int>, double> hole_edges;  // by their nodes in the order of the neighbour, with y
    for (const int e : open.members()) {
        const auto& nodes = mesh.elements[at(e)];
        for (std::size_t k = 0; k < 4; ++k) hole_edges[{nodes[(k + 1) % 4], nodes[k]}] = centre(mesh, e).y();
    }
    for (const int e : open.complement().members()) {
        const auto& nodes = mesh.elements[at(e)];
        for (std::size_t k = 0; k < 4; ++k) {
            const auto edge = hole_edges.find({nodes[k], nodes[(k + 1) % 4]});
            if (edge == hole_edges.end()) continue;
            mesh.boundary[edge->second > 0.0 ? "hole-top" : "hole-bottom"].push_back({e, static_cast<int>(k)});
        }
    }
}

/// The mesh without the open elements, and without nodes that no other element has.
Mesh without(const Mesh& mesh, const ElementSet& open) {
    std::vector<int> new_element(mesh.elements.size(), -1), new_node(mesh.nodes.size(), -1);
    Mesh rest;
    for (const int e : open.complement().members()) {
        new_element[at(e)] = static_cast<int>(rest.elements.size());
        rest.elements.push_back(mesh.elements[at(e)]);
        for (const int node : mesh.elements[at(e)]) new_node[at(node)] = 0;
    }
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        if (new_node[n] < 0) continue;
        new_node[n] = static_cast<int>(rest.nodes.size());
        rest.nodes.push_back(mesh.nodes[n]);
    }
    for (auto& element : rest.elements)
        for (int& node : element) node = new_node[at(node)];
    for (const auto& [name, edges] : mesh.boundary)
        for (const auto& [element, edge] : edges) rest.boundary[name].push_back({new_element[at(element)], edge});
    return rest;
}

}  // namespace

Body compact_tension(const MeshSection& section) {
    const double W = section.width;
    return {Vec2(-front * W, -half_height * W), Vec2(W, half_height * W)};
}

Mesh compact_tension_mesh(const MeshSection& section, const MeshLines& lines) {
    const double W = section.width;
    Mesh filled = structured_mesh(section, compact_tension(section), lines);
    std::vector<int> pins;
    for (const double side : {-1.0, 1.0}) {
        const std::vector<int> pin = pin_elements(filled, Vec2(0.0, side * hole_height * W), hole_radius * W);
        pins.insert(pins.end(), pin.begin(), pin.end());
    }
    std::ranges::sort(pins);
    const ElementSet open = open_holes(filled, pins, W);
    name_hole_edges(filled, open);

    Mesh mesh = without(filled, open);
    mesh.load_line = 0.0;
    for (const double side : {-1.0, 1.0}) {
        const Vec2 pin(0.0, side * hole_height * W);
        SpreadPoint spread = spread_over(mesh, pin_elements(mesh, pin, hole_radius * W), pin);
        spread.opposite = side > 0.0 ? "pin-bottom" : "pin-top";
        mesh.pins.emplace(side > 0.0 ? "pin-top" : "pin-bottom", std::move(spread));
    }
    for (int element = 0; element < static_cast<int>(mesh.elements.size()); ++element) {
        const Vec2 middle = centre(mesh, element);
        if ((middle - pin_near(middle, W)).norm() <= insert_radius * W) mesh.insert.push_back(element);
    }
    return mesh;
}

}  // namespace stria::coarse
