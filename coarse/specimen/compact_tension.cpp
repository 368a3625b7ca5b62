#include "coarse/specimen/compact_tension.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "coarse/specimen/pin_hole.hpp"
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

PinHole hole(double side, double width) {
    return {Vec2(0.0, side * hole_height * width), hole_radius * width, insert_radius * width};
}
/// That at the height of x.
PinHole hole_near(const Vec2& x, double width) { return hole(std::copysign(1.0, x.y()), width); }

/// Those that are asked for, and those of both holes.
MeshLines with_lines_of_holes(MeshLines lines, double width) {
    for (const double side : {-1.0, 1.0})
        for (const int axis : {0, 1})
            for (const double line : hole(side, width).lines(axis)) lines[at(axis)].push_back(line);
    keep_each_once(lines);
    return lines;
}

/// The pin presses along the load on the outer part of its hole's edge, evenly over the width across the load: the
/// resultant acts on the load line whatever the edges.
SpreadPoint spread_over_arc(const Mesh& mesh, const std::vector<BoundaryEdge>& edges, const PinHole& hole) {
    std::map<int, double> width_of;
    double width = 0.0;
    for (const auto& [element, k] : edges) {
        const auto& nodes = mesh.elements[at(element)];
        const std::array<int, 2> ends{nodes[at(k)], nodes[at((k + 1) % 4)]};
        const Vec2 from = mesh.nodes[at(ends[0])], to = mesh.nodes[at(ends[1])];
        const Vec2 arm = 0.5 * (from + to) - hole.middle;
        if (std::atan2(std::abs(arm.x()), std::copysign(1.0, hole.middle.y()) * arm.y()) > contact_angle) continue;
        const double across = std::abs(to.x() - from.x());
        width += across;
        for (const int node : ends) width_of[node] += 0.5 * across;
    }
    SpreadPoint result;
    for (const auto& [node, share] : width_of) result.shares.push_back({node, share / width});
    return result;
}

/// The elements in the holes.
ElementSet elements_of_holes(const Mesh& mesh, double width) {
    ElementSet open(mesh.elements.size());
    for (int element = 0; element < open.size(); ++element) {
        const Vec2 middle = centre(mesh, element);
        if (hole_near(middle, width).square_holds(middle)) open.insert(element);
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
    Mesh filled = structured_mesh(section, compact_tension(section), with_lines_of_holes(lines, W));
    const ElementSet open = elements_of_holes(filled, W);
    name_hole_edges(filled, open);

    Mesh mesh = without(filled, open);
    for (Vec2& node : mesh.nodes) node = hole_near(node, W).moved(node);
    mesh.load_line = 0.0;
    for (const double side : {-1.0, 1.0}) {
        const char* edges = side > 0.0 ? "hole-top" : "hole-bottom";
        SpreadPoint spread = spread_over_arc(mesh, mesh.boundary.at(edges), hole(side, W));
        spread.opposite = side > 0.0 ? "pin-bottom" : "pin-top";
        mesh.pins.emplace(side > 0.0 ? "pin-top" : "pin-bottom", std::move(spread));
    }
    for (int element = 0; element < static_cast<int>(mesh.elements.size()); ++element) {
        const Vec2 middle = centre(mesh, element);
        if ((middle - hole_near(middle, W).middle).norm() <= insert_radius * W) mesh.insert.push_back(element);
    }
    return mesh;
}

}  // namespace stria::coarse
