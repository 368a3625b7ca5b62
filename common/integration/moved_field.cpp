#include "common/integration/moved_field.hpp"

#include <algorithm>
#include <unsupported/Eigen/BVH>

#include "common/fem/shape_q4.hpp"
#include "common/index.hpp"
#include "common/integration/element_field.hpp"

namespace stria {
namespace {

/// Finds the element of a mesh that holds a place.
class Places {
public:
    explicit Places(const EnrichedMesh& mesh) : mesh_(mesh) {
        std::vector<int> elements;
        std::vector<Eigen::AlignedBox2d> boxes;
        for (int e = 0; e < std::ssize(mesh.elements); ++e) {
            Eigen::AlignedBox2d box;
            for (const int node : mesh.elements[at(e)]) box.extend(mesh.nodes[at(node)]);
            elements.push_back(e);
            boxes.push_back(box);
        }
        tree_.init(elements.begin(), elements.end(), boxes.begin(), boxes.end());
    }

    /// -1: none.
    [[nodiscard]] int element_at(const Vec2& x) const {
        Query query{mesh_, x};
        Eigen::BVIntersect(tree_, query);
        return query.found;
    }

    [[nodiscard]] int node_nearest_to(const Vec2& x) const {
        const auto distance = [&](const Vec2& node) { return (node - x).squaredNorm(); };
        return static_cast<int>(std::ranges::min_element(mesh_.nodes, {}, distance) - mesh_.nodes.begin());
    }

private:
    struct Query {
        const EnrichedMesh& mesh;
        Vec2 x;
        int found = -1;

        [[nodiscard]] bool intersectVolume(const Eigen::AlignedBox2d& box) const { return box.contains(x); }
        bool intersectObject(int element) {
            QuadNodes corners;
            for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh.nodes[at(mesh.elements[at(element)][k])];
            constexpr double edge = 1.0 + 1e-6;
            if (map_to_parent(corners, x).lpNorm<Eigen::Infinity>() > edge) return false;
            found = element;
            return true;
        }
    };

    const EnrichedMesh& mesh_;
    Eigen::KdBVH<double, 2, int> tree_;
};

/// The rows of a node's unknowns.
class Rows {
public:
    void add(int unknown, const std::vector<ElementField::Share>& shares) {
        for (const auto& [column, weight] : shares)
            for (const int c : {0, 1}) entries_.emplace_back(unknown + c, column + c, weight);
    }
    [[nodiscard]] SparseRows matrix(int rows, int columns) const {
        SparseRows matrix(rows, columns);
        matrix.setFromTriplets(entries_.begin(), entries_.end());
        return matrix;
    }

private:
    std::vector<Triplet> entries_;
};

}  // namespace

bool MovedField::can_move(const EnrichedMesh& from, const EnrichedMesh& to) {
    return from.tip_functions == 0 && to.tip_functions == 0 && from.tips.size() == to.tips.size() &&
           !from.nodes.empty();
}

Vec2 move_of_nearest_tip(const EnrichedMesh& from, const EnrichedMesh& to, const Vec2& x) {
    if (to.tips.empty()) return Vec2::Zero();
    const auto distance = [&](const Tip& tip) { return (tip.position - x).squaredNorm(); };
    const auto nearest = std::ranges::min_element(to.tips, {}, distance);
    return nearest->position - from.tips[at(nearest - to.tips.begin())].position;
}

MovedField::MovedField(const EnrichedMesh& from, const EnrichedMesh& to) {
    const Places places(from);
    const std::vector<int> piece = piece_of_elements(from);
    Rows rows;
    for (int node = 0; node < std::ssize(to.nodes); ++node) {
        const Vec2 behind = to.nodes[at(node)] - move_of_nearest_tip(from, to, to.nodes[at(node)]);
        const int element = places.element_at(behind);
        if (element < 0) {
            const int nearest = places.node_nearest_to(behind);
            if (!to.follows(node, 0) && !from.follows(nearest, 0))
                rows.add(to.unknown(node, 0, 0), {{from.unknown(nearest, 0, 0), 1.0}});
            continue;
        }
        const int p = piece[at(element)];
        const ElementField field(from, element, p >= 0 ? &from.pieces[at(p)] : nullptr);
        if (!to.follows(node, 0)) rows.add(to.unknown(node, 0, 0), field.at_place(behind));
        const auto& terms = to.terms[at(node)];
        for (int term = 1; term <= std::ssize(terms) && field.is_cut(); ++term)
            if (!to.follows(node, term)) rows.add(to.unknown(node, term, 0), field.half_jump(behind));
    }
    weights_ = rows.matrix(to.unknowns, from.unknowns);
}

}  // namespace stria
