#include "common/crack/crack_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <set>

#include "common/crack/crack_crossings.hpp"
#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/geometry/clipping.hpp"
#include "common/geometry/segment.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

class Resolver {
public:
    Resolver(const BodyMesh& mesh, int crack, const std::vector<Vec2>& points)
        : mesh_(mesh), crack_(crack), points_(points), skeleton_(mesh, points), crossings_(skeleton_.all()),
          arc_(skeleton_.arc()) {}

    CrackPath resolve() {
        CrackPath path;
        path.length = arc_.back();
        path.tip_at_start = inside_body(points_.front());
        path.tip_at_end = inside_body(points_.back());
        drop_slivers_at_tips(path);
        if (crossings_.empty()) {
            if (!path.tip_at_start) throw CaseError(fmt::format("crack {}: it does not meet the body", crack_));
            path.pieces.push_back(piece(nullptr, nullptr));
        } else {
            append_pieces(path);
        }
        check(path);
        return path;
    }

private:
    [[nodiscard]] bool inside_body(const Vec2& x) const {
        for (const MeshEdge& edge : skeleton_.edges()) {
            if (edge.elements[1] >= 0 || !skeleton_.is_boundary(edge)) continue;
            if (intersect(x, x, node(edge.first), node(edge.second))) return false;
        }
        return std::ranges::any_of(mesh_.elements_near(x), [&](int e) { return side_of(e, x) >= 0; });
    }

    /// Of an element, as side_of_polygon(): most are told by a look at their corners.
    [[nodiscard]] int side_of(int e, const Vec2& x) const {
        const std::array<Vec2, 4> corners = polygon(e);
        Eigen::AlignedBox2d box;
        for (const Vec2& corner : corners) box.extend(corner);
        return box.contains(x) ? side_of_polygon(corners, x) : -1;
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
        if (path.pieces.empty()) throw CaseError(fmt::format("crack {}: it does not meet the body", crack_));
    }

    std::optional<CrackPiece> between(const Crossing& a, const Crossing& b) {
        const auto chain = points_between(&a, &b);
        const std::vector<int> shared = skeleton_.common_elements(a, b);
        const bool along_edge = chain.first.size() == 2 && skeleton_.on_one_edge(a, b);
        if (along_edge) return along(a, b, chain, shared);
        if (chain.first.size() > 2) {
            refuse_bend_on_edge(chain.first[0], chain.first[1]);
            refuse_bend_on_edge(chain.first.back(), chain.first[chain.first.size() - 2]);
        }
        const Vec2 middle = (chain.first[0] + chain.first[1]) / 2.0;
        for (const int e : shared) {
            const int inside = side_of_polygon(polygon(e), middle);
            if (inside > 0) return make_piece(e, chain, &a, &b);
            if (inside == 0) refuse_partial_edge(b.position);
        }
        return std::nullopt;  // outside the body
    }

    CrackPiece along(const Crossing& a, const Crossing& b,
                     const std::pair<std::vector<Vec2>, std::vector<double>>& chain, const std::vector<int>& shared) {
        const bool whole_edge = a.node >= 0 && b.node >= 0;
        // From a node to where it turns into one of both elements, or back: only that element is cut beside the piece.
        const bool leaves = (a.node >= 0 && skeleton_.bends_at(b)) || (skeleton_.bends_at(a) && b.node >= 0);
        const bool ends_at_tip =
            (&b == &crossings_.back() && ends_on_edge_) || (&a == &crossings_.front() && starts_on_edge_);
        if (shared.size() != 2 || !(whole_edge || ends_at_tip || leaves)) refuse_partial_edge(b.position);
        const bool first_is_left = orientation(a.position, b.position, centre(*mesh_, shared[0])) > 0;
        CrackPiece result = make_piece(first_is_left ? shared[1] : shared[0], chain, &a, &b);
        result.neighbour = first_is_left ? shared[0] : shared[1];
        return result;
    }

    [[noreturn]] void refuse_partial_edge(const Vec2& x) const {
        throw CrackOffMesh(
            fmt::format("crack {}: near ({:.6g}, {:.6g}) it runs along the boundary, or along part of an element edge; "
                        "change the mesh size a little",
                        crack_, x.x(), x.y()));
    }

    // To rounding, whichever side an ulp puts it on.
    [[nodiscard]] bool lies_on(const MeshEdge& edge, const Vec2& x) const {
        const Vec2 &first = node(edge.first), &second = node(edge.second);
        return distance_to_segment(x, first, second) <= 1e-9 * (first - second).norm();
    }

    // The edge between two elements that holds all of a chain, if one does.
    [[nodiscard]] const MeshEdge* edge_of(const std::vector<Vec2>& points) const {
        const auto holds_all = [&](const MeshEdge& edge) {
            return edge.elements[1] >= 0 &&
                   std::ranges::all_of(points, [&](const Vec2& x) { return lies_on(edge, x); });
        };
        const auto found = std::ranges::find_if(skeleton_.edges(), holds_all);
        return found != skeleton_.edges().end() ? &*found : nullptr;
    }

    // The crack has come along an edge and leaves it there, which is no crossing.
    void refuse_bend_on_edge(const Vec2& end, const Vec2& bend) const {
        const auto holds = [&](const MeshEdge& edge) { return lies_on(edge, end) && lies_on(edge, bend); };
        if (std::ranges::any_of(skeleton_.edges(), holds)) refuse_partial_edge(bend);
    }

    // A piece that ends at a tip inside an element (null end), or lies wholly inside one.
    CrackPiece piece(const Crossing* a, const Crossing* b) {
        const auto chain = points_between(a, b);
        const Vec2 middle = (chain.first[0] + chain.first[1]) / 2.0;
        if (a != nullptr || b != nullptr) {
            const std::vector<Vec2>& points = chain.first;
            if (const MeshEdge* edge = edge_of(points)) {  // both elements beside it hold the tip
                const int left =
                    orientation(points.front(), points.back(), centre(*mesh_, edge->elements[0])) > 0 ? 0 : 1;
                CrackPiece result = make_piece(edge->elements[at(1 - left)], chain, a, b);
                result.neighbour = edge->elements[at(left)];
                return result;
            }
            if (a != nullptr) refuse_bend_on_edge(points[0], points[1]);
            if (b != nullptr) refuse_bend_on_edge(points.back(), points[points.size() - 2]);
        }
        for (const int e : mesh_.elements_near(middle)) {
            const int inside = side_of(e, middle);
            if (inside > 0) return make_piece(e, chain, a, b);
            if (inside == 0) refuse_partial_edge(middle);  // and then leaves it, or it would be one of the above
        }
        throw CaseError(
            fmt::format("crack {}: no element holds the crack near ({:.6g}, {:.6g})", crack_, middle.x(), middle.y()));
    }

    CrackPiece make_piece(int e, const std::pair<std::vector<Vec2>, std::vector<double>>& chain, const Crossing* a,
                          const Crossing* b) const {
        CrackPiece result;
        result.crack = crack_;
        result.element = e;
        result.points = chain.first;
        result.s = chain.second;
        if (a != nullptr) result.entry = skeleton_.place(e, *a);
        if (b != nullptr) result.exit = skeleton_.place(e, *b);
        return result;
    }

    [[nodiscard]] std::pair<std::vector<Vec2>, std::vector<double>> points_between(const Crossing* a,
                                                                                   const Crossing* b) const {
        const double s0 = a != nullptr ? a->s : 0.0, s1 = b != nullptr ? b->s : arc_.back();
        std::pair<std::vector<Vec2>, std::vector<double>> chain;
        chain.first.push_back(a != nullptr ? a->position : points_.front());
        chain.second.push_back(s0);
        for (std::size_t k = 1; k + 1 < points_.size(); ++k) {
            if (arc_[k] <= s0 + skeleton_.kink_tolerance() || arc_[k] >= s1 - skeleton_.kink_tolerance()) continue;
            chain.first.push_back(points_[k]);
            chain.second.push_back(arc_[k]);
        }
        chain.first.push_back(b != nullptr ? b->position : points_.back());
        chain.second.push_back(s1);
        return chain;
    }

    void check(const CrackPath& path) const {
        for (std::size_t k = 0; k + 1 < path.pieces.size(); ++k) {
            const Vec2& x = path.pieces[k].points.back();
            if (path.pieces[k + 1].s.front() - path.pieces[k].s.back() <= 1e-9 * path.length) continue;
            throw CaseError(fmt::format("crack {}: at ({:.6g}, {:.6g}) it leaves the body and comes back; give the "
                                        "parts as cracks of their own",
                                        crack_, x.x(), x.y()));
        }
        std::set<int> crossed;
        for (const CrackPiece& p : path.pieces) {
            if (p.neighbour >= 0) continue;
            if (!crossed.insert(p.element).second) {
                throw CrackOffMesh(
                    fmt::format("crack {}: it enters the element at ({:.6g}, {:.6g}) twice; use smaller elements there",
                                crack_, p.points[0].x(), p.points[0].y()));
            }
        }
    }

    [[nodiscard]] const Vec2& node(int n) const { return mesh_->nodes[at(n)]; }

    [[nodiscard]] std::array<Vec2, 4> polygon(int e) const {
        const auto& n = mesh_->elements[at(e)];
        return {node(n[0]), node(n[1]), node(n[2]), node(n[3])};
    }

    const BodyMesh& mesh_;
    int crack_;
    const std::vector<Vec2>& points_;
    CrackCrossings skeleton_;
    const std::vector<Crossing>& crossings_;
    const std::vector<double>& arc_;
    bool starts_on_edge_ = false, ends_on_edge_ = false;
};

/// The sides of a crack are told apart at kinks of up to a right angle.
void refuse_turning_back(int crack, const std::vector<Vec2>& points) {
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
        if ((points[k] - points[k - 1]).dot(points[k + 1] - points[k]) >= 0.0) continue;
        throw CaseError(
            fmt::format("crack {}: at ({:.6g}, {:.6g}) it turns by more than 90 degrees, it may go on by up to 90",
                        crack, points[k].x(), points[k].y()));
    }
}

}  // namespace

double CrackPath::mouth() const {
    if (!tip_at_start) return pieces.front().s.front();
    return tip_at_end ? std::numeric_limits<double>::quiet_NaN() : pieces.back().s.back();
}

CrackPath resolve_crack(const BodyMesh& mesh, int crack, const std::vector<Vec2>& points) {
    const std::vector<Vec2> snapped = snapped_onto_mesh(mesh, points);
    refuse_turning_back(crack, snapped);
    CrackPath path = Resolver(mesh, crack, snapped).resolve();
    path.points = snapped;
    return path;
}

}  // namespace stria
