// Quadrilateral background mesh with named boundary edges. Never changes once made.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/vec2.hpp"
#include "common/index.hpp"
#include "common/index_lists.hpp"

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

/// The middle of an edge of one element that its neighbours across the edge, half as large, have as a corner.
struct HangingNode {
    int node;
    std::array<int, 2> ends;  // of the edge
    int larger;               // the element
};

struct Mesh {
    std::vector<Vec2> nodes;                                    // mm
    std::vector<std::array<int, 4>> elements;                   // counter-clockwise
    std::vector<int> level;                                     // how often each element was split; empty: none was
    std::vector<HangingNode> hanging;                           // ascending by node
    std::map<std::string, std::vector<BoundaryEdge>> boundary;  // by name; all edges of the body, each once or oftener
    std::map<std::string, std::vector<int>> groups;             // of elements, by name, each ascending (mesh files)
    /// Nodes that are held, by name, each ascending; where a boundary has the name they are held besides.
    std::map<std::string, std::vector<int>> node_sets;
    std::map<std::string, SpreadPoint> pins;  // by name: "pin-top", "pin-bottom"
    std::vector<int> material;                // of each element (materials.hpp); empty: all are of material 0
    std::vector<int> insert;                  // ascending: elements that stay elastic at any stress (around pins)
    std::optional<double> load_line;          // x, mm: crack lengths are measured from there (CT)

    [[nodiscard]] int material_of(int element) const { return material.empty() ? 0 : material[at(element)]; }
    [[nodiscard]] int level_of(int element) const { return level.empty() ? 0 : level[at(element)]; }
    [[nodiscard]] bool is_split(int element) const { return level_of(element) > 0; }
    [[nodiscard]] bool in_insert(int element) const {
        return std::binary_search(insert.begin(), insert.end(), element);
    }
};

[[nodiscard]] int nearest_node(const Mesh& mesh, const Vec2& place);
/// Whether a node is at a place, to a millionth of the shortest edge around it.
[[nodiscard]] bool is_at(const Mesh& mesh, int node, const Vec2& place);

/// For each node the elements around it, in element order; around a hanging node then the larger one.
IndexLists elements_around_nodes(const Mesh& mesh);

}  // namespace stria
