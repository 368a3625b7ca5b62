#include "common/integration/moved_field.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <unsupported/Eigen/BVH>
#include <utility>

#include "common/enrichment/same_functions.hpp"
#include "common/fem/centre.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/geometry/points_by_place.hpp"
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

    /// One or, on an edge, several.
    [[nodiscard]] std::vector<int> elements_at(const Vec2& x) const {
        Query query{mesh_, x, {}};
        Eigen::BVIntersect(tree_, query);
        return query.found;
    }

private:
    struct Query {
        const EnrichedMesh& mesh;
        Vec2 x;
        std::vector<int> found;

        [[nodiscard]] bool intersectVolume(const Eigen::AlignedBox2d& box) const {
            return box.squaredExteriorDistance(x) <= 1e-12 * box.sizes().squaredNorm();
        }
        bool intersectObject(int element) {
            if (is_in(element)) found.push_back(element);
            return false;  // go on
        }
        // To rounding; far outside a slanted element there are no parent coordinates to ask for.
        [[nodiscard]] bool is_in(int element) const {
            const QuadNodes corners = corners_of_element(mesh, element);
            const double off = -0.25e-6 * cross(corners[2] - corners[0], corners[3] - corners[1]);
            for (std::size_t k = 0; k < 4; ++k)
                if (cross(corners[(k + 1) % 4] - corners[k], x - corners[k]) < off) return false;
            return true;
        }
    };

    const EnrichedMesh& mesh_;
    Eigen::KdBVH<double, 2, int> tree_;
};

/// Whether two nodes have the same functions: none that follow others, and at most one jump.
bool have_same_functions(const EnrichedMesh& mesh, int node, const EnrichedMesh& other, int other_node) {
    return mesh.terms[at(node)].size() < 2 && !mesh.has_tip_functions(node) &&
           same_functions_at(node, mesh, other_node, other) && mesh.tie(node) == nullptr &&
           other.tie(other_node) == nullptr;
}

/// Of elements, as they are asked for.
class Fields {
public:
    explicit Fields(const EnrichedMesh& mesh)
        : mesh_(mesh), piece_(piece_of_elements(mesh)), fields_(mesh.elements.size()) {}

    const ElementField& of(int element) {
        std::optional<ElementField>& field = fields_[at(element)];
        if (!field) field.emplace(mesh_, element, mesh_.piece(piece_[at(element)]));
        return *field;
    }

    /// The same where nothing jumps: the shape functions. Nothing elsewhere.
    [[nodiscard]] std::optional<Shares> plain(int element, const Vec2& x) const {
        const std::array<int, 4>& nodes = mesh_.elements[at(element)];
        const auto jumps = [&](int node) {
            const TiedNode* const tie = mesh_.tie(node);
            const auto has_terms = [&](int own) { return !mesh_.terms[at(own)].empty(); };
            return has_terms(node) || (tie != nullptr && std::ranges::any_of(tie->ends, has_terms));
        };
        if (piece_[at(element)] >= 0 || std::ranges::any_of(nodes, jumps)) return std::nullopt;
        const Eigen::Vector4d value = shape_values(map_to_parent(corners_of_element(mesh_, element), x));
        Shares shares;
        for (std::size_t k = 0; k < 4; ++k) {
            const double weight = value[static_cast<Eigen::Index>(k)];
            const TiedNode* const tie = mesh_.tie(nodes[k]);
            if (tie == nullptr)
                shares.push_back({mesh_.unknown(nodes[k], 0, 0), weight});
            else
                for (const int end : tie->ends) shares.push_back({mesh_.unknown(end, 0, 0), 0.5 * weight});
        }
        return shares;
    }

private:
    const EnrichedMesh& mesh_;
    std::vector<int> piece_;
    std::vector<std::optional<ElementField>> fields_;
};

double smallest_size(const EnrichedMesh& mesh) {
    double least = std::numeric_limits<double>::infinity();
    for (int e = 0; e < std::ssize(mesh.elements); ++e) least = std::min(least, edge_of_square(mesh, e));
    return least;
}

/// What the unknowns of a mesh are in those of another, at places there.
class FieldByPlace {
public:
    FieldByPlace(const EnrichedMesh& from, const EnrichedMesh& to)
        : from_(from), to_(to), nodes_(from.nodes, smallest_size(from)), fields_(from) {}

    /// Those of a node are those at a place. False where there is no element.
    bool add(int node, const Vec2& x) { return has_no_unknowns(node) || copy(node, x) || interpolate(node, x); }

    void add_nearest(int node, const Vec2& x) {
        const auto distance = [&](const Vec2& other) { return (other - x).squaredNorm(); };
        add(node, *std::ranges::min_element(from_.nodes, {}, distance));
    }

    std::vector<MovedField::Part> parts;

private:
    [[nodiscard]] bool has_no_unknowns(int node) const {
        return to_.follows(node, 0) && (to_.terms[at(node)].empty() || to_.follows(node, 1));
    }

    // A move is one of whole elements: most nodes come to lie on nodes.
    bool copy(int node, const Vec2& x) {
        const int old = nodes_.at_place(x);
        if (old < 0 || !have_same_functions(to_, node, from_, old)) return false;
        for (int term = 0; term <= std::ssize(to_.terms[at(node)]); ++term)
            parts.push_back({to_.unknown(node, term, 0), from_.unknown(old, term, 0), 1.0});
        return true;
    }

    bool interpolate(int node, const Vec2& x) {
        if (!places_) places_.emplace(from_);
        std::vector<int> found = places_->elements_at(x);
        if (found.empty()) return false;
        const auto& terms = to_.terms[at(node)];
        if (terms.empty()) {
            if (const std::optional<Shares> shares = fields_.plain(found.front(), x)) {
                put(to_.unknown(node, 0, 0), *shares);
                return true;
            }
        }
        FieldAtNode field(x, terms);
        if (terms.empty()) found.resize(1);  // what does not jump has one value
        for (const int element : found) field.add(fields_.of(element));
        if (!to_.follows(node, 0) && field.standard()) put(to_.unknown(node, 0, 0), *field.standard());
        const std::optional<Shares> jump = field.half_jump();
        for (int term = 1; term <= std::ssize(terms) && jump; ++term)
            if (!to_.follows(node, term)) put(to_.unknown(node, term, 0), *jump);
        return true;
    }

    void put(int unknown, const Shares& shares) {
        for (const auto& [before, weight] : shares) parts.push_back({unknown, before, weight});
    }

    const EnrichedMesh &from_, &to_;
    PointsByPlace nodes_;
    std::optional<Places> places_;
    Fields fields_;
};

int element_nearest_to(const EnrichedMesh& mesh, const Vec2& x) {
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int e = 0; e < std::ssize(mesh.elements); ++e) {
        const double distance = (centre(mesh, e) - x).squaredNorm();
        if (distance < least) nearest = e, least = distance;
    }
    return nearest;
}

/// Whether the mesh about a tip, taken back by a move, has the nodes of the mesh before.
bool lies_on_itself(const EnrichedMesh& from, const EnrichedMesh& to, const Vec2& tip, double size, const Vec2& move) {
    constexpr double about = 3.0, off = 0.05;  // elements
    std::vector<Vec2> before;                  // that may lie there
    for (const Vec2& old : from.nodes)
        if ((old + move - tip).norm() < (about + 2.0 * off) * size) before.push_back(old);
    return std::ranges::all_of(to.nodes, [&](const Vec2& node) {
        if ((node - tip).norm() > about * size) return true;
        return std::ranges::any_of(before, [&](const Vec2& old) { return (node - move - old).norm() < off * size; });
    });
}

}  // namespace

std::optional<TipMoves> TipMoves::between(const EnrichedMesh& from, const EnrichedMesh& to) {
    if (from.tip_functions > 0 || to.tip_functions > 0 || from.tips.size() != to.tips.size()) return std::nullopt;
    if (from.elements.empty() || to.elements.empty()) return std::nullopt;
    TipMoves moves;
    for (std::size_t t = 0; t < to.tips.size(); ++t) {
        const Vec2 &tip = to.tips[t].position, before = from.tips[t].position;
        const Vec2 old = centre(from, element_nearest_to(from, before));
        const int now = element_nearest_to(to, old + tip - before);
        const Vec2 move = tip == before ? Vec2::Zero() : Vec2(centre(to, now) - old);
        if (tip != before && !lies_on_itself(from, to, tip, edge_of_square(to, now), move)) return std::nullopt;
        moves.tips.push_back(tip);
        moves.moves.push_back(move);
    }
    return moves;
}

bool TipMoves::are_none() const {
    return std::ranges::all_of(moves, [](const Vec2& move) { return move.isZero(0.0); });
}

Vec2 TipMoves::of_nearest_tip(const Vec2& x) const {
    if (tips.empty()) return Vec2::Zero();
    const auto nearest = std::ranges::min_element(tips, {}, [&](const Vec2& tip) { return (tip - x).squaredNorm(); });
    return moves[at(nearest - tips.begin())];
}

MovedField::MovedField(const EnrichedMesh& from, const EnrichedMesh& to, const TipMoves& moves)
    : unknowns_(to.unknowns) {
    FieldByPlace field(from, to);
    for (int node = 0; node < std::ssize(to.nodes); ++node) {
        const Vec2& here = to.nodes[at(node)];
        // At the body's boundary, or at the zone's, there may be nothing behind.
        if (!field.add(node, here - moves.of_nearest_tip(here)) && !field.add(node, here))
            field.add_nearest(node, here);
    }
    parts_ = std::move(field.parts);
}

Eigen::MatrixXd MovedField::of(const Eigen::MatrixXd& values) const {
    Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(unknowns_, values.cols());
    for (Eigen::Index k = 0; k < values.cols(); ++k)
        for (const auto& [unknown, before, weight] : parts_)
            moved.col(k).segment<2>(unknown) += weight * values.col(k).segment<2>(before);
    return moved;
}

}  // namespace stria
