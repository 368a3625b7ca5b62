// Quadrilateral background mesh with named boundary edges. Never changes once made.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace stria {

/// Edge k of an element runs from its node k to node (k + 1) % 4; the body lies to the left.
struct BoundaryEdge {
    int element;
    int edge;
};

struct Mesh {
    std::vector<Eigen::Vector2d> nodes;                         // mm
    std::vector<std::array<int, 4>> elements;                   // counter-clockwise
    std::map<std::string, std::vector<BoundaryEdge>> boundary;  // by name: "top", "bottom", "left", "right", ...
};

/// For each node the elements around it, in element order.
std::vector<std::vector<int>> elements_around_nodes(const std::vector<std::array<int, 4>>& elements,
                                                    std::size_t node_count);

}  // namespace stria
