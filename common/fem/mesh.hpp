// Quadrilateral background mesh with named boundary edges. Never changes once made.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace stria {

/// Edge k of an element runs from its node k to node (k + 1) % 4; the body lies to the left.
struct BoundaryEdge {
    int element;
    int edge;
};

/// Where a force is spread over the body: its resultant and its moment are those of the force at one point.
struct SpreadPoint {
    struct Share {
        int node;
        double weight;  // they add up to 1
    };
    std::vector<Share> shares;
    std::string opposite;  // displacements are measured relative to it
};

struct Mesh {
    std::vector<Eigen::Vector2d> nodes;                         // mm
    std::vector<std::array<int, 4>> elements;                   // counter-clockwise
    std::map<std::string, std::vector<BoundaryEdge>> boundary;  // by name: "top", "bottom", "left", "right", ...
    std::map<std::string, SpreadPoint> pins;                    // by name: "pin-top", "pin-bottom"
    std::vector<int> insert;          // ascending: elements that stay elastic at any stress (around pins)
    std::optional<double> load_line;  // x, mm: crack lengths are measured from there (CT)

    [[nodiscard]] bool in_insert(int element) const {
        return std::binary_search(insert.begin(), insert.end(), element);
    }
};

/// For each node the elements around it, in element order.
std::vector<std::vector<int>> elements_around_nodes(const std::vector<std::array<int, 4>>& elements,
                                                    std::size_t node_count);

}  // namespace stria
