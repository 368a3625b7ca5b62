// Where a crack polyline meets the skeleton of a mesh: at nodes, and inside element edges.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "common/fem/body_mesh.hpp"
#include "common/geometry/vec2.hpp"
#include "common/index.hpp"

namespace stria {

/// Part of an element's edge between two neighbouring nodes: half of it where a node hangs in its middle.
struct MeshEdge {
    int first, second;  // nodes, first < second
    std::array<int, 2> elements{-1, -1};
};

/// The crack meets the skeleton: at a node, or inside an edge.
struct Crossing {
    double s;  // arc length, mm
    Vec2 position;
    int node;              // -1: inside an edge
    const MeshEdge* edge;  // null at a node
    double fraction;       // along the edge from its first node
};

/// A crossing nearer to a node than this fraction of the edge is snapped onto the node (docs/method.md, section 2).
inline constexpr double snap_fraction = 1e-3;

/// The same polyline, with points that are that near to a node put onto it, each once: a tip or a kink beside the node
/// at which the crack crosses would leave a piece between both that runs anywhere. Points that are a millionth of an
/// edge's length beside it are put onto it: what a crack along the edge would cut off there has no stiffness. Ends on
/// the outline, to rounding, are put a little beyond it.
std::vector<Vec2> snapped_onto_mesh(const BodyMesh& mesh, const std::vector<Vec2>& points);

class CrackCrossings {
public:
    /// The points must outlive it. Whether a crossing exists is decided by exact predicates.
    CrackCrossings(BodyMesh mesh, const std::vector<Vec2>& points);
    CrackCrossings(const CrackCrossings&) = delete;  // crossings point to its edges
    CrackCrossings& operator=(const CrackCrossings&) = delete;

    /// Ascending along the crack; of those that are one place to rounding, or graze a node, one is left.
    [[nodiscard]] const std::vector<Crossing>& all() const { return crossings_; }

    /// Of the elements near the crack.
    [[nodiscard]] const std::vector<MeshEdge>& edges() const { return edges_; }

    /// Arc length of each point of the polyline.
    [[nodiscard]] const std::vector<double>& arc() const { return arc_; }

    /// Arc lengths nearer than this are one, mm.
    [[nodiscard]] double kink_tolerance() const { return 1e-12 * arc_.back(); }

    /// True where no second element lies across the edge, near the crack or not.
    [[nodiscard]] bool is_boundary(const MeshEdge& edge) const;

    /// Place of a crossing on an element's boundary (CrackPiece::entry).
    [[nodiscard]] double place(int element, const Crossing& crossing) const;

    [[nodiscard]] std::vector<int> common_elements(const Crossing& a, const Crossing& b) const;
    [[nodiscard]] bool on_one_edge(const Crossing& a, const Crossing& b) const;
    /// The crack turns there, inside an edge.
    [[nodiscard]] bool bends_at(const Crossing& crossing) const {
        return crossing.node < 0 &&
               has_kink_between(crossing.s - 2.0 * kink_tolerance(), crossing.s + 2.0 * kink_tolerance());
    }

private:
    void collect_edges();
    [[nodiscard]] bool meets_crack(const Eigen::AlignedBox2d& box) const;
    void collect();
    void add_hanging_nodes();
    void add_bends_on_edges();
    void add(const MeshEdge& edge, std::size_t segment, const Vec2& found);
    [[nodiscard]] double fraction_of(const MeshEdge& edge, std::size_t segment, const Vec2& found) const;
    void merge();
    [[nodiscard]] bool grazes(const Crossing& a, const Crossing& b) const;
    [[nodiscard]] bool has_kink_between(double s0, double s1) const;
    [[nodiscard]] int middle_of(int a, int b) const;  // the hanging node in the middle of an edge, or -1
    [[nodiscard]] std::vector<int> elements_at(const Crossing& crossing) const;
    [[nodiscard]] const Vec2& node(int n) const { return mesh_->nodes[at(n)]; }

    BodyMesh mesh_;
    const std::vector<Vec2>& points_;
    std::map<std::pair<int, int>, int> middle_;  // hanging node of an edge
    std::set<int> hanging_near_;                 // of elements near the crack
    std::vector<double> arc_;
    std::vector<MeshEdge> edges_;
    std::vector<Crossing> crossings_;
};

}  // namespace stria
