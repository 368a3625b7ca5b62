#include "common/fem/crack_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "common/error.hpp"
#include "common/geometry/clipping.hpp"

namespace stria {
namespace {

struct MeshEdge {
    int first, second;  // nodes, first < second
    std::array<int, 2> elements{-1, -1};
};

/// The crack meets the skeleton of the mesh: at a node, or inside an edge.
struct Crossing {
    double s;
    Vec2 position;
    int node;              // -1: inside an edge
    const MeshEdge* edge;  // null at a node
    double fraction;       // along the edge from its first node
};

class Resolver {
public:
    Resolver(const Mesh& mesh, int crack, const std::vector<Vec2>& points)
        : mesh_(mesh), crack_(crack), points_(points), around_(elements_around_nodes(mesh)) {
        for (const HangingNode& hanging : mesh.hanging)
            middle_[edge_key(hanging.ends[0], hanging.ends[1])] = hanging.node;
        arc_.push_back(0.0);
        for (std::size_t k = 1; k < points.size(); ++k)
            arc_.push_back(arc_.back() + (points[k] - points[k - 1]).norm());
        collect_edges();
    }

    CrackPath resolve() {
        CrackPath path;
        path.length = arc_.back();
        collect_crossings();
        path.tip_at_start = inside_body(points_.front());
        path.tip_at_end = inside_body(points_.back());
        drop_slivers_at_tips(path);
        if (crossings_.empty()) {
            if (!path.tip_at_start) throw CaseError(fmt::format("crack {}: it does not meet the body", crack_ + 1));
            path.pieces.push_back(piece(nullptr, nullptr));
        } else {
            append_pieces(path);
        }
        check(path);
        return path;
    }

private:
    void collect_edges() {
        std::map<std::pair<int, int>, std::size_t> index;
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
            if (!near_crack(static_cast<int>(e))) continue;
            const auto add = [&](int from, int to) {
                const auto key = edge_key(from, to);
                const auto [found, added] = index.try_emplace(key, edges_.size());
                if (added)
                    edges_.push_back({key.first, key.second, {static_cast<int>(e), -1}});
                else
                    edges_[found->second].elements[1] = static_cast<int>(e);
            };
            for (std::size_t k = 0; k < 4; ++k) {
                const int from = mesh_.elements[e][k], to = mesh_.elements[e][(k + 1) % 4],
                          middle = middle_of(from, to);
                add(from, middle >= 0 ? middle : to);
                if (middle >= 0) add(middle, to);
            }
        }
    }

    static std::pair<int, int> edge_key(int a, int b) { return std::minmax(a, b); }

    /// The hanging node in the middle of an edge, or -1.
    [[nodiscard]] int middle_of(int a, int b) const {
        const auto found = middle_.find(edge_key(a, b));
        return found != middle_.end() ? found->second : -1;
    }

    [[nodiscard]] bool near_crack(int e) const {
        Eigen::AlignedBox2d box;
        for (const int node : mesh_.elements[static_cast<std::size_t>(e)])
            box.extend(mesh_.nodes[static_cast<std::size_t>(node)]);
        const double margin = 1e-9 * box.diagonal().norm();
        box.extend(Vec2(box.min() - Vec2::Constant(margin))).extend(Vec2(box.max() + Vec2::Constant(margin)));
        for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
            Eigen::AlignedBox2d segment(points_[k]);
            if (box.intersects(segment.extend(points_[k + 1]))) return true;
        }
        return false;
    }

    void collect_crossings() {
        for (const MeshEdge& edge : edges_) {
            const Vec2 &a = node(edge.first), &b = node(edge.second);
            for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
                const auto common = intersect(points_[k], points_[k + 1], a, b);
                if (!common) continue;
                add_crossing(edge, k, common->first);
                if (common->first != common->second) add_crossing(edge, k, common->second);
            }
        }
        std::ranges::stable_sort(crossings_, {}, &Crossing::s);
        merge_crossings();
    }

    void add_crossing(const MeshEdge& edge, std::size_t segment, const Vec2& x) {
        const Vec2 &a = node(edge.first), &b = node(edge.second);
        const double t = (x - a).dot(b - a) / (b - a).squaredNorm();
        const double s = arc_[segment] + (x - points_[segment]).norm();
        if (t < snap_fraction)
            crossings_.push_back({s, a, edge.first, nullptr, 0.0});
        else if (t > 1.0 - snap_fraction)
            crossings_.push_back({s, b, edge.second, nullptr, 0.0});
        else
            crossings_.push_back({s, x, -1, &edge, t});
    }

    [[nodiscard]] static bool same_place(const Crossing& a, const Crossing& b) {
        if (a.node >= 0 && b.node >= 0) return a.node == b.node;
        if (a.edge != nullptr && b.edge != nullptr) return a.edge == b.edge && std::abs(a.fraction - b.fraction) < 1e-9;
        return false;
    }

    // A node and a point of an edge that ends there, with no kink between: the crack grazes the node (or the whole
    // edge), and once snapped onto the node it no longer crosses that edge.
    [[nodiscard]] bool grazes(const Crossing& a, const Crossing& b) const {
        const Crossing &at_node = a.node >= 0 ? a : b, &on_edge = a.node >= 0 ? b : a;
        if (at_node.node < 0 || on_edge.edge == nullptr || has_kink_between(a.s, b.s)) return false;
        return on_edge.edge->first == at_node.node || on_edge.edge->second == at_node.node;
    }

    void merge_crossings() {
        std::vector<Crossing> merged;
        for (const Crossing& crossing : crossings_) {
            if (!merged.empty() && same_place(merged.back(), crossing)) continue;
            if (!merged.empty() && grazes(merged.back(), crossing)) {
                if (crossing.node >= 0) merged.back() = crossing;
                if (merged.size() > 1 && same_place(merged[merged.size() - 2], merged.back())) merged.pop_back();
                continue;
            }
            merged.push_back(crossing);
        }
        crossings_ = std::move(merged);
    }

    [[nodiscard]] bool has_kink_between(double s0, double s1) const {
        for (std::size_t k = 1; k + 1 < points_.size(); ++k) {
            if (arc_[k] > s0 + kink_tolerance() && arc_[k] < s1 - kink_tolerance()) return true;
        }
        return false;
    }

    [[nodiscard]] double kink_tolerance() const { return 1e-12 * arc_.back(); }

    [[nodiscard]] bool inside_body(const Vec2& x) const {
        for (const MeshEdge& edge : edges_) {
            if (edge.elements[1] >= 0 || !is_boundary(edge)) continue;
            if (intersect(x, x, node(edge.first), node(edge.second))) return false;
        }
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
            if (side_of_polygon(polygon(static_cast<int>(e)), x) >= 0) return true;
        }
        return false;
    }

    // An edge met once near the crack may have its other element farther away.
    [[nodiscard]] bool is_boundary(const MeshEdge& edge) const {
        const auto& others = around_[static_cast<std::size_t>(edge.second)];
        return std::ranges::count_if(around_[static_cast<std::size_t>(edge.first)],
                                     [&](int e) { return std::ranges::find(others, e) != others.end(); }) == 1;
    }

    // A tip within rounding of an edge ends on that edge.
    void drop_slivers_at_tips(const CrackPath& path) {
        const double tiny = 1e-9 * arc_.back();
        if (path.tip_at_end && !crossings_.empty() && arc_.back() - crossings_.back().s < tiny) ends_on_edge_ = true;
        if (path.tip_at_start && !crossings_.empty() && crossings_.front().s < tiny) starts_on_edge_ = true;
    }

    void append_pieces(CrackPath& path) {
        if (path.tip_at_start && !starts_on_edge_) path.pieces.push_back(piece(nullptr, &crossings_.front()));
        for (std::size_t k = 0; k + 1 < crossings_.size(); ++k) {
            if (auto next = between(crossings_[k], crossings_[k + 1])) path.pieces.push_back(std::move(*next));
        }
        if (path.tip_at_end && !ends_on_edge_) path.pieces.push_back(piece(&crossings_.back(), nullptr));
        if (path.pieces.empty()) throw CaseError(fmt::format("crack {}: it does not meet the body", crack_ + 1));
    }

    std::optional<CrackPiece> between(const Crossing& a, const Crossing& b) {
        const auto chain = points_between(&a, &b);
        const std::vector<int> shared = common_elements(a, b);
        const bool along_edge = chain.first.size() == 2 && on_one_edge(a, b);
        if (along_edge) return along(a, b, chain, shared);
        const Vec2 middle = (chain.first[0] + chain.first[1]) / 2.0;
        for (const int e : shared) {
            const int inside = side_of_polygon(polygon(e), middle);
            if (inside > 0) return make_piece(e, chain, &a, &b);
            if (inside == 0) refuse_partial_edge(b);
        }
        return std::nullopt;  // outside the body
    }

    CrackPiece along(const Crossing& a, const Crossing& b,
                     const std::pair<std::vector<Vec2>, std::vector<double>>& chain, const std::vector<int>& shared) {
        const bool whole_edge = a.node >= 0 && b.node >= 0;
        const bool ends_at_tip =
            (&b == &crossings_.back() && ends_on_edge_) || (&a == &crossings_.front() && starts_on_edge_);
        if (shared.size() != 2 || !(whole_edge || ends_at_tip)) refuse_partial_edge(b);
        const bool first_is_left = orientation(a.position, b.position, centre(shared[0])) > 0;
        CrackPiece result = make_piece(first_is_left ? shared[1] : shared[0], chain, &a, &b);
        result.neighbour = first_is_left ? shared[0] : shared[1];
        return result;
    }

    [[noreturn]] void refuse_partial_edge(const Crossing& b) const {
        throw CaseError(
            fmt::format("crack {}: near ({}, {}) it runs along the boundary, or along part of an element edge; "
                        "change the mesh size a little",
                        crack_ + 1, b.position.x(), b.position.y()));
    }

    // A piece that ends at a tip inside an element (null end), or lies wholly inside one.
    CrackPiece piece(const Crossing* a, const Crossing* b) {
        const auto chain = points_between(a, b);
        const Vec2 middle = (chain.first[0] + chain.first[1]) / 2.0;
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
            if (side_of_polygon(polygon(static_cast<int>(e)), middle) > 0)
                return make_piece(static_cast<int>(e), chain, a, b);
        }
        // The tip lies on an edge that the crack runs along: both elements beside it hold the tip.
        const Crossing* end = a != nullptr ? a : b;
        for (const MeshEdge& edge : edges_) {
            const Vec2 tip = a != nullptr ? chain.first.back() : chain.first.front();
            if (end == nullptr || !intersect(tip, tip, node(edge.first), node(edge.second))) continue;
            const int left = orientation(chain.first.front(), chain.first.back(), centre(edge.elements[0])) > 0 ? 0 : 1;
            CrackPiece result = make_piece(edge.elements[static_cast<std::size_t>(1 - left)], chain, a, b);
            result.neighbour = edge.elements[static_cast<std::size_t>(left)];
            return result;
        }
        throw CaseError(
            fmt::format("crack {}: no element holds the crack near ({}, {})", crack_ + 1, middle.x(), middle.y()));
    }

    CrackPiece make_piece(int e, const std::pair<std::vector<Vec2>, std::vector<double>>& chain, const Crossing* a,
                          const Crossing* b) const {
        CrackPiece result;
        result.crack = crack_;
        result.element = e;
        result.points = chain.first;
        result.s = chain.second;
        if (a != nullptr) result.entry = place(e, *a);
        if (b != nullptr) result.exit = place(e, *b);
        return result;
    }

    [[nodiscard]] std::pair<std::vector<Vec2>, std::vector<double>> points_between(const Crossing* a,
                                                                                   const Crossing* b) const {
        const double s0 = a != nullptr ? a->s : 0.0, s1 = b != nullptr ? b->s : arc_.back();
        std::pair<std::vector<Vec2>, std::vector<double>> chain;
        chain.first.push_back(a != nullptr ? a->position : points_.front());
        chain.second.push_back(s0);
        for (std::size_t k = 1; k + 1 < points_.size(); ++k) {
            if (arc_[k] <= s0 + kink_tolerance() || arc_[k] >= s1 - kink_tolerance()) continue;
            chain.first.push_back(points_[k]);
            chain.second.push_back(arc_[k]);
        }
        chain.first.push_back(b != nullptr ? b->position : points_.back());
        chain.second.push_back(s1);
        return chain;
    }

    [[nodiscard]] double place(int e, const Crossing& crossing) const {
        const auto& nodes = mesh_.elements[static_cast<std::size_t>(e)];
        for (std::size_t k = 0; k < 4; ++k) {
            const int from = nodes[k], to = nodes[(k + 1) % 4], middle = middle_of(from, to);
            const auto edge = static_cast<double>(k);
            if (crossing.node >= 0 && crossing.node == from) return edge;
            if (crossing.node >= 0 && crossing.node == middle) return edge + 0.5;
            if (crossing.edge == nullptr) continue;
            if (middle < 0) {
                if (const auto t = fraction(crossing, from, to)) return edge + *t;
                continue;
            }
            if (const auto t = fraction(crossing, from, middle)) return edge + 0.5 * *t;
            if (const auto t = fraction(crossing, middle, to)) return edge + 0.5 + 0.5 * *t;
        }
        require(crossing.node < 0 && crossing.edge == nullptr, "a crossing lies on the boundary of its element");
        return -1.0;
    }

    /// Of the way along an edge, where the crossing lies on it.
    [[nodiscard]] static std::optional<double> fraction(const Crossing& crossing, int from, int to) {
        if (from == crossing.edge->first && to == crossing.edge->second) return crossing.fraction;
        if (from == crossing.edge->second && to == crossing.edge->first) return 1.0 - crossing.fraction;
        return std::nullopt;
    }

    [[nodiscard]] std::vector<int> elements_at(const Crossing& crossing) const {
        if (crossing.node >= 0) return around_[static_cast<std::size_t>(crossing.node)];
        std::vector<int> result;
        for (const int e : crossing.edge->elements)
            if (e >= 0) result.push_back(e);
        return result;
    }

    [[nodiscard]] std::vector<int> common_elements(const Crossing& a, const Crossing& b) const {
        std::vector<int> result;
        const std::vector<int> others = elements_at(b);
        for (const int e : elements_at(a))
            if (std::ranges::find(others, e) != others.end()) result.push_back(e);
        return result;
    }

    [[nodiscard]] static bool on_one_edge(const Crossing& a, const Crossing& b, const MeshEdge& edge) {
        const auto on = [&](const Crossing& c) {
            return c.edge == &edge || (c.node >= 0 && (c.node == edge.first || c.node == edge.second));
        };
        return on(a) && on(b);
    }

    [[nodiscard]] bool on_one_edge(const Crossing& a, const Crossing& b) const {
        return std::ranges::any_of(edges_, [&](const MeshEdge& edge) { return on_one_edge(a, b, edge); });
    }

    void check(const CrackPath& path) const {
        std::set<int> crossed;
        for (const CrackPiece& p : path.pieces) {
            if (p.neighbour >= 0) continue;
            if (!crossed.insert(p.element).second) {
                throw CaseError(
                    fmt::format("crack {}: it enters the element at ({}, {}) twice; use smaller elements there",
                                crack_ + 1, p.points[0].x(), p.points[0].y()));
            }
        }
    }

    [[nodiscard]] const Vec2& node(int n) const { return mesh_.nodes[static_cast<std::size_t>(n)]; }

    [[nodiscard]] std::array<Vec2, 4> polygon(int e) const {
        const auto& n = mesh_.elements[static_cast<std::size_t>(e)];
        return {node(n[0]), node(n[1]), node(n[2]), node(n[3])};
    }

    [[nodiscard]] Vec2 centre(int e) const {
        const auto corners = polygon(e);
        return (corners[0] + corners[1] + corners[2] + corners[3]) / 4.0;
    }

    const Mesh& mesh_;
    int crack_;
    const std::vector<Vec2>& points_;
    std::vector<std::vector<int>> around_;
    std::map<std::pair<int, int>, int> middle_;  // hanging node of an edge
    std::vector<double> arc_;
    std::vector<MeshEdge> edges_;
    std::vector<Crossing> crossings_;
    bool starts_on_edge_ = false, ends_on_edge_ = false;
};

}  // namespace

CrackPath resolve_crack(const Mesh& mesh, int crack, const std::vector<Vec2>& points) {
    return Resolver(mesh, crack, points).resolve();
}

}  // namespace stria
