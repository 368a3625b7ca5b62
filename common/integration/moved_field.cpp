#include "common/integration/moved_field.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/BVH>

#include "common/fem/centre.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/index.hpp"
#include "common/integration/element_field.hpp"

namespace stria {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

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

    [[nodiscard]] int node_nearest_to(const Vec2& x) const {
        const auto distance = [&](const Vec2& node) { return (node - x).squaredNorm(); };
        return static_cast<int>(std::ranges::min_element(mesh_.nodes, {}, distance) - mesh_.nodes.begin());
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
            QuadNodes corners;
            for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh.nodes[at(mesh.elements[at(element)][k])];
            const double off = -0.25e-6 * cross(corners[2] - corners[0], corners[3] - corners[1]);
            for (std::size_t k = 0; k < 4; ++k)
                if (cross(corners[(k + 1) % 4] - corners[k], x - corners[k]) < off) return false;
            return true;
        }
    };

    const EnrichedMesh& mesh_;
    Eigen::KdBVH<double, 2, int> tree_;
};

/// The first unknown of a node where nothing jumps at it and it follows no others; else -1.
int plain_unknown(const EnrichedMesh& mesh, int node) {
    return mesh.terms[at(node)].empty() && !mesh.follows(node, 0) ? mesh.unknown(node, 0, 0) : -1;
}

/// The same of a mesh that may have the node.
int plain_unknown(const EnrichedMesh& mesh, int id, const Vec2& x) {
    const auto found = std::ranges::lower_bound(mesh.node_ids, id);
    const int node = static_cast<int>(found - mesh.node_ids.begin());
    const bool has_it = found != mesh.node_ids.end() && *found == id && mesh.nodes[at(node)] == x;
    return has_it ? plain_unknown(mesh, node) : -1;
}

/// Of elements, as they are asked for.
class Fields {
public:
    explicit Fields(const EnrichedMesh& mesh)
        : mesh_(mesh), piece_(piece_of_elements(mesh)), fields_(mesh.elements.size()) {}

    const ElementField& of(int element) {
        std::optional<ElementField>& field = fields_[at(element)];
        const int p = piece_[at(element)];
        if (!field) field.emplace(mesh_, element, p >= 0 ? &mesh_.pieces[at(p)] : nullptr);
        return *field;
    }

    /// The same where nothing jumps and nothing hangs: the shape functions. Nothing elsewhere.
    [[nodiscard]] std::optional<Shares> plain(int element, const Vec2& x) const {
        if (piece_[at(element)] >= 0) return std::nullopt;
        QuadNodes corners;
        Shares shares;
        for (std::size_t k = 0; k < 4; ++k) {
            const int node = mesh_.elements[at(element)][k];
            corners[k] = mesh_.nodes[at(node)];
            shares.push_back({plain_unknown(mesh_, node), 0.0});
            if (shares.back().unknown < 0) return std::nullopt;
        }
        const Eigen::Vector4d value = shape_values(map_to_parent(corners, x));
        for (std::size_t k = 0; k < 4; ++k) shares[k].weight = value[static_cast<Eigen::Index>(k)];
        return shares;
    }

private:
    const EnrichedMesh& mesh_;
    std::vector<int> piece_;
    std::vector<std::optional<ElementField>> fields_;
};

/// The rows of a node's unknowns.
class Rows {
public:
    void add(int unknown, const Shares& shares) {
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

double size_of(const EnrichedMesh& mesh, int element) {
    const auto& nodes = mesh.elements[at(element)];
    return (mesh.nodes[at(nodes[0])] - mesh.nodes[at(nodes[2])]).norm() / std::numbers::sqrt2;
}

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
        if (tip != before && !lies_on_itself(from, to, tip, size_of(to, now), move)) return std::nullopt;
        moves.tips.push_back(tip);
        moves.moves.push_back(move);
    }
    return moves;
}

Vec2 TipMoves::of_nearest_tip(const Vec2& x) const {
    if (tips.empty()) return Vec2::Zero();
    const auto nearest = std::ranges::min_element(tips, {}, [&](const Vec2& tip) { return (tip - x).squaredNorm(); });
    return moves[at(nearest - tips.begin())];
}

MovedField::MovedField(const EnrichedMesh& from, const EnrichedMesh& to, const TipMoves& moves) {
    const Places places(from);
    Fields fields(from);
    Rows rows;
    for (int node = 0; node < std::ssize(to.nodes); ++node) {
        const Vec2 here = to.nodes[at(node)];
        Vec2 x = here - moves.of_nearest_tip(here);
        const int plain = plain_unknown(to, node);
        if (const int before = plain >= 0 && x == here ? plain_unknown(from, to.node_ids[at(node)], here) : -1;
            before >= 0) {
            rows.add(plain, {{before, 1.0}});
            continue;
        }
        std::vector<int> found = places.elements_at(x);
        if (found.empty()) found = places.elements_at(x = here);  // at the body's boundary, or at the zone's
        if (found.empty()) {
            const int nearest = places.node_nearest_to(here);
            x = from.nodes[at(nearest)];
            found = places.elements_at(x);
        }
        if (const std::optional<Shares> shares = plain >= 0 ? fields.plain(found.front(), x) : std::nullopt) {
            rows.add(plain, *shares);
            continue;
        }
        const auto& terms = to.terms[at(node)];
        FieldAtNode field(x, terms);
        if (terms.empty()) found.resize(1);  // what does not jump has one value
        for (const int element : found) field.add(fields.of(element));
        if (!to.follows(node, 0) && field.standard()) rows.add(to.unknown(node, 0, 0), *field.standard());
        const std::optional<Shares> jump = field.half_jump();
        for (int term = 1; term <= std::ssize(terms) && jump; ++term)
            if (!to.follows(node, term)) rows.add(to.unknown(node, term, 0), *jump);
    }
    weights_ = rows.matrix(to.unknowns, from.unknowns);
}

}  // namespace stria
