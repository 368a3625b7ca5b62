#include "coarse/enrichment/crack_front.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <ranges>
#include <span>
#include <utility>

#include "common/crack/crack_crossings.hpp"
#include "common/fem/centre.hpp"
#include "common/fem/quadrature.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/geometry/segment.hpp"
#include "common/index.hpp"
#include "common/index_set.hpp"

namespace stria::coarse {
namespace {

struct Exit {
    double distance;  // from the tip, mm
    double place;     // as CrackPiece::exit
    Vec2 position;
};

/// Where a ray from inside a convex element, or along one of its edges, leaves it. As near to a node as crossings
/// are snapped onto it, it leaves there.
Exit leaves(const std::array<Vec2, 4>& corners, const Vec2& from, const Vec2& direction) {
    Exit exit{-1.0, 0.0, from};
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 &a = corners[k], edge = corners[(k + 1) % 4] - a;
        const double across = cross(direction, edge);
        if (across <= 1e-9 * edge.norm()) continue;  // of the edges that it faces from inside
        const double distance = cross(a - from, edge) / across;
        if (exit.distance >= 0.0 && distance >= exit.distance) continue;
        const double t = std::clamp(edge.dot(from + distance * direction - a) / edge.squaredNorm(), 0.0, 1.0);
        const double snapped = t < snap_fraction ? 0.0 : t > 1.0 - snap_fraction ? 1.0 : t;
        exit = {distance, std::fmod(static_cast<double>(k) + snapped, 4.0), a + snapped * edge};
    }
    return exit;
}

/// Length of the edges of a square of its area, mm.
double size_of(const std::array<Vec2, 4>& corners) {
    return std::sqrt(0.5 * cross(corners[2] - corners[0], corners[3] - corners[1]));
}

bool is_at_node(double place) { return place == std::floor(place); }

/// From one place of an edge to another one of it nothing jumps: its ends hold none, or no whole edge opens.
bool returns_to_its_edge(const CrackPiece& piece, double exit) {
    if (piece.entry < 0.0 || (piece.neighbour >= 0 && is_at_node(piece.entry))) return false;
    const auto lies_on = [](double place, int edge) { return std::fmod(place - edge + 4.0, 4.0) <= 1.0; };
    return std::ranges::any_of(std::views::iota(0, 4),
                               [&](int edge) { return lies_on(piece.entry, edge) && lies_on(exit, edge); });
}

/// The last piece runs along the second half of an edge, and the one before along the first: the whole edge opens.
bool ends_a_whole_edge(const Mesh& mesh, std::span<const CrackPiece> pieces) {
    if (pieces.size() < 2) return false;
    const CrackPiece &first = pieces[pieces.size() - 2], &second = pieces.back();
    if (first.neighbour < 0 || second.neighbour < 0 || first.entry < 0.0) return false;
    if (first.element == second.element) return is_at_node(first.entry) && !is_at_node(second.entry);
    if (first.neighbour != second.neighbour || !is_at_node(second.entry)) return false;
    const int between = mesh.elements[at(second.element)][at(static_cast<int>(second.entry)) % 4];
    return std::ranges::any_of(mesh.hanging, [&](const HangingNode& hanging) {
        return hanging.node == between && hanging.larger == second.neighbour;
    });
}

/// Of the crack at a tip. Beside an edge it is that of the edge: what is shorter than rounding puts between it and the
/// edge may point anywhere.
Vec2 heading(const std::array<Vec2, 4>& corners, const CrackPiece& last) {
    const Vec2 &tip = last.points.back(), way = tip - last.points[last.points.size() - 2];
    if (last.neighbour < 0) return way.normalized();
    Vec2 nearest = way;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 edge = (corners[(k + 1) % 4] - corners[k]).normalized();
        const double off = std::abs(cross(edge, tip - corners[k]));
        if (off < least) nearest = way.dot(edge) > 0.0 ? edge : Vec2(-edge), least = off;
    }
    return nearest;
}

/// Of the edge that a piece of a path ends on, or the node: nothing jumps there.
std::set<int> closed_nodes(const Mesh& mesh, std::span<const CrackPiece> pieces, const CrackPiece& piece,
                           double place) {
    const auto& nodes = mesh.elements[at(piece.element)];
    const auto edge = at(static_cast<int>(place));
    std::set<int> closed{nodes[edge % 4]};
    if (!is_at_node(place)) closed.insert(nodes[(edge + 1) % 4]);
    // What hangs on an edge that the crack meets opens with the ends of the edge: they are closed, too.
    for (const auto& [node, ends, larger] : mesh.hanging) {
        if (!closed.contains(node)) continue;
        const Vec2 &a = mesh.nodes[at(ends[0])], &b = mesh.nodes[at(ends[1])];
        const double rounding = 1e-9 * (b - a).norm();
        const auto lies_there = [&](const Vec2& x) { return distance_to_segment(x, a, b) <= rounding; };
        if (std::ranges::any_of(pieces, [&](const CrackPiece& met) {
                return lies_there(met.points.front()) || lies_there(met.points.back());
            }))
            closed.insert(ends.begin(), ends.end());
    }
    return closed;
}

/// Of so many first pieces, as those that open: as near to the tip as they seem to end, and closing in a short stretch.
/// As few where two serve alike.
std::size_t nearest_front(const Mesh& mesh, std::span<const CrackPiece> pieces, double tip) {
    constexpr double rounding = 1e-6;
    constexpr std::size_t candidates = 4;  // the ends of the last pieces: farther back none is as near
    double least = std::numeric_limits<double>::infinity();
    std::size_t best = pieces.size();
    for (std::size_t count = pieces.size() - std::min(candidates, pieces.size()) + 1; count <= pieces.size(); ++count) {
        const double earlier = lag(mesh, pieces.first(count));
        const double off = std::abs(pieces[count - 1].s.back() - earlier - tip) + std::max(earlier, 0.0);
        if (off < (1.0 - rounding) * least) least = off, best = count;
    }
    return best;
}

/// The piece of a straight crack in the next element; none beyond a node, or beside an element of another size.
std::optional<CrackPiece> straight_on(const BodyMesh& mesh, const CrackPiece& last, const Vec2& direction) {
    if (is_at_node(last.exit)) return std::nullopt;
    const auto& own = mesh->elements[at(last.element)];
    const auto edge = at(static_cast<int>(last.exit));
    const int begins = own[edge % 4], ends = own[(edge + 1) % 4];
    for (const int e : mesh.around()[at(begins)]) {
        const auto& nodes = mesh->elements[at(e)];
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            if (nodes[k] != ends || nodes[(k + 1) % 4] != begins) continue;  // all run counter-clockwise
            const Vec2 &from = last.points.back(), &first = mesh->nodes[at(nodes[k])];
            const Exit exit = leaves(corners_of_element(*mesh, e), from, direction);
            CrackPiece piece;
            piece.crack = last.crack;
            piece.element = e;
            piece.points = {from, exit.position};
            piece.s = {last.s.back(), last.s.back() + (exit.position - from).norm()};
            piece.entry =
                static_cast<double>(k) + (from - first).norm() / (mesh->nodes[at(nodes[(k + 1) % 4])] - first).norm();
            piece.exit = exit.place;
            return piece;
        }
    }
    return std::nullopt;
}

/// The front at the end of the last piece, which holds a tip.
void end_on_edge(const BodyMesh& mesh, std::vector<CrackPiece>& pieces) {
    constexpr double rounding = 1e-6;
    CrackPiece& last = pieces.back();
    const Vec2 tip = last.points.back();
    const std::array<Vec2, 4> corners = corners_of_element(*mesh, last.element);
    const Vec2 direction = heading(corners, last);
    const Exit exit = leaves(corners, tip, direction);
    const double s = last.s.back(), behind = s - last.s.front();
    const double least = last.neighbour >= 0 ? 1.0 + rounding : rounding;  // along an edge nothing is cut off
    const bool falls_back = behind <= least * exit.distance || returns_to_its_edge(last, exit.place);
    if (pieces.size() > 1 && falls_back && !ends_a_whole_edge(mesh, pieces)) {
        pieces.pop_back();
        return;
    }
    last.s.back() += (exit.position - tip).norm();
    last.points.back() = exit.position;
    last.exit = exit.place;
    if (pieces.size() == 1 || last.neighbour >= 0) return;
    // Not far: a crack that turns at its tip would not open it.
    constexpr double far = 0.5;
    const std::optional<CrackPiece> next = straight_on(mesh, last, direction);
    if (next && next->s.back() - next->s.front() < far * size_of(corners) && !returns_to_its_edge(*next, next->exit))
        pieces.push_back(*next);
    pieces.resize(nearest_front(mesh, pieces, s));
}

void turn_round(std::vector<CrackPiece>& pieces, double length) {
    std::ranges::reverse(pieces);
    for (CrackPiece& piece : pieces) {
        std::ranges::reverse(piece.points);
        std::ranges::reverse(piece.s);
        for (double& s : piece.s) s = length - s;
        std::swap(piece.entry, piece.exit);
    }
}

}  // namespace

CrackPath with_fronts_on_edges(const BodyMesh& mesh, CrackPath path) {
    const double length = path.length;
    const auto is_inside = [](const CrackPiece& piece, double place) {
        return place < 0.0 || (piece.neighbour >= 0 && !is_at_node(place));
    };
    if (path.tip_at_end && is_inside(path.pieces.back(), path.pieces.back().exit)) end_on_edge(mesh, path.pieces);
    if (path.tip_at_start && is_inside(path.pieces.front(), path.pieces.front().entry)) {
        turn_round(path.pieces, length);
        end_on_edge(mesh, path.pieces);
        turn_round(path.pieces, length);
    }
    return path;
}

// What the closed nodes take of the jump, integrated along the crack, is half an element's size where it leaves its
// last element across from where it came in, and more where it cuts off a corner.
double lag(const Mesh& mesh, std::span<const CrackPiece> pieces) {
    const std::set<int> closed = closed_nodes(mesh, pieces, pieces.back(), pieces.back().exit);
    double taken = 0.0;
    for (const CrackPiece& piece : pieces | std::views::reverse) {
        const auto& nodes = mesh.elements[at(piece.element)];
        if (!contains_any(closed, nodes)) break;
        for (std::size_t k = 0; k + 1 < piece.points.size(); ++k) {
            const Vec2 middle = 0.5 * (piece.points[k] + piece.points[k + 1]), half = piece.points[k + 1] - middle;
            for (const auto& [xi, weight] : gauss_line(2)) {
                const Eigen::Vector4d shape =
                    shape_values(map_to_parent(corners_of_element(mesh, piece.element), middle + xi * half));
                for (std::size_t i = 0; i < nodes.size(); ++i)
                    if (closed.contains(nodes[i])) taken += weight * half.norm() * shape[static_cast<Eigen::Index>(i)];
            }
        }
    }
    constexpr double of_K = 1.4;  // measured: verification.CrackFronts
    return of_K * (taken - 0.5 * size_of(corners_of_element(mesh, pieces.back().element)));
}

std::set<int> front_nodes(const Mesh& mesh, const CrackPath& path, bool start) {
    const CrackPiece& piece = start ? path.pieces.front() : path.pieces.back();
    const double place = start ? piece.entry : piece.exit;
    return closed_nodes(mesh, path.pieces, piece, place);
}

}  // namespace stria::coarse
