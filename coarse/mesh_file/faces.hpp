// The faces of a mesh file, each of them sound: counter-clockwise and convex, in one plane.
#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "coarse/mesh_file/part.hpp"
#include "common/geometry/vec2.hpp"

namespace stria::coarse {

/// One face has three or four corners.
struct Face {
    Number number;           // in the file
    std::vector<int> nodes;  // counter-clockwise
};

/// Edge k of a face runs from its node k to the next one.
struct FaceEdge {
    int face;
    int edge;
};

/// The nodes of an edge, ascending.
using NodePair = std::pair<int, int>;

struct Edge {
    NodePair nodes;
    std::vector<FaceEdge> sides;  // one at the boundary, else two

    [[nodiscard]] bool is_boundary() const { return sides.size() == 1; }
};

struct Faces {
    std::vector<Vec2> nodes;      // mm; those that a face has
    std::vector<Number> numbers;  // of the nodes, in the file
    std::vector<Face> faces;
    std::map<std::string, std::vector<int>> regions;  // ascending
    std::vector<Edge> edges;                          // ascending
    std::unordered_map<Number, int> node_of;          // by its number in the file
    int turned = 0, unused_nodes = 0;                 // faces that were clockwise; nodes

    /// Null: no face has an edge between these nodes.
    [[nodiscard]] const Edge* find_edge(const NodePair& ends) const;
};

/// Throws CaseError that begins with `name` and says which node or element of the file is wrong.
Faces faces_of(const Part& part, const std::string& name);

}  // namespace stria::coarse
