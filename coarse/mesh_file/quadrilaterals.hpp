// Faces as quadrilaterals: where any is a triangle, each is split at its centre and the middles of its edges.
#pragma once

#include "coarse/mesh_file/faces.hpp"
#include "common/fem/mesh.hpp"

namespace stria::coarse {

class Quadrilaterals {
public:
    explicit Quadrilaterals(const Faces& faces);

    /// Nodes and elements alone.
    [[nodiscard]] Mesh mesh() const { return mesh_; }

    /// The elements that a face has become, ascending.
    [[nodiscard]] std::vector<int> parts(int face) const;

    /// The edges of elements that an edge has become.
    [[nodiscard]] std::vector<BoundaryEdge> parts(const FaceEdge& edge) const;

    [[nodiscard]] bool split() const { return split_; }

private:
    int middle(const NodePair& edge);

    const Faces& faces_;
    Mesh mesh_;
    bool split_;
    std::vector<int> first_;  // element of each face; where faces are split its parts follow, one per corner
    std::map<NodePair, int> middle_;
};

}  // namespace stria::coarse
