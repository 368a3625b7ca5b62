#include "coarse/enrichment/crack_sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "coarse/enrichment/tip_support.hpp"
#include "common/enrichment/tip_functions.hpp"
#include "common/fem/centre.hpp"
#include "common/geometry/clipping.hpp"
#include "common/geometry/segment.hpp"
#include "common/index.hpp"
#include "common/index_set.hpp"
#include "common/integration/cut_element.hpp"

namespace stria::coarse {
namespace {

/// Of a place beside a bend.
int side_of_bend(const Vec2& before, const Vec2& bend, const Vec2& after, const Vec2& x) {
    const bool left_of_first = orientation(before, bend, x) > 0, left_of_second = orientation(bend, after, x) > 0;
    const bool turns_left = orientation(before, bend, after) >= 0;
    return (turns_left ? left_of_first && left_of_second : left_of_first || left_of_second) ? 1 : -1;
}

}  // namespace

CrackSides::CrackSides(BodyMesh mesh, const CrackPath& path) : mesh_(std::move(mesh)), path_(path) {
    for (const CrackPiece& piece : path.pieces) {
        note_piece(piece);
        if (piece.neighbour < 0) cut_.insert(piece.element);
        for (const Vec2& x : piece.points)
            if (points_.empty() || points_.back() != x) points_.push_back(x);
    }
    note_hanging_nodes();
}

void CrackSides::note_piece(const CrackPiece& piece) {
    for (const double place : {piece.entry, piece.exit}) note_if_node(piece, place);
    const bool holds_tip = piece.entry < 0.0 || piece.exit < 0.0;
    if (piece.neighbour >= 0 || holds_tip) return;
    for (const int node : mesh_->elements[at(piece.element)])
        if (!on_crack_.contains(node)) of_nodes_[node] = side_in(piece, mesh_->nodes[at(node)]);
}

int CrackSides::side_in(const CrackPiece& piece, const Vec2& x) const {
    return side_of_polygon(cut_element(corners_of_element(*mesh_, piece.element), piece).left, x) >= 0 ? 1 : -1;
}

// The elements at a hanging node may all be whole but for the larger one, of which it is no corner.
void CrackSides::note_hanging_nodes() {
    of_hanging_too_ = of_nodes_;
    std::map<int, const CrackPiece*> cut;
    for (const CrackPiece& piece : path_.pieces)
        if (piece.neighbour < 0) cut[piece.element] = &piece;
    for (const auto& [node, ends, larger] : mesh_->hanging) {
        const auto piece = cut.find(larger);
        const Vec2& x = mesh_->nodes[at(node)];
        if (piece == cut.end() || of_nodes_.contains(node)) continue;
        const auto along = std::ranges::find_if(path_.pieces, [&](const CrackPiece& beside) {
            const bool meets = beside.points.front() == x || beside.points.back() == x;
            return meets && beside.neighbour >= 0 && (beside.element == larger || beside.neighbour == larger);
        });
        if (along != path_.pieces.end()) of_hanging_too_[node] = along->element == larger ? 1 : -1;  // it lies beyond
        if (along != path_.pieces.end() || piece->second->points.front() == x || piece->second->points.back() == x)
            continue;
        constexpr double inwards = 1e-9;  // rounding puts the middle of an edge on either side of it
        of_hanging_too_[node] = side_in(*piece->second, x + inwards * (centre(*mesh_, larger) - x));
    }
}

void CrackSides::note_if_node(const CrackPiece& piece, double place) {
    if (place < 0.0 || place != std::floor(place)) return;
    const int node = mesh_->elements[at(piece.element)][at(static_cast<int>(place) % 4)];
    of_nodes_[node] = 1;
    on_crack_.insert(node);
}

int CrackSides::near_tip(const CrackPiece& piece, int node) const {
    if (on_crack_.contains(node)) return 1;
    const Vec2& x = mesh_->nodes[at(node)];
    const std::array<int, 4>& own = mesh_->elements[at(piece.element)];
    if (piece.neighbour < 0 && std::ranges::find(own, node) != own.end()) return side_in(piece, x);
    // Along an edge, or at the end of one: the crack may have come to it through an element beside it.
    if (const auto known = of_nodes_.find(node); known != of_nodes_.end()) return known->second;
    const bool ends_there = path_.tip_at_end && piece.points.back() == path_.pieces.back().points.back();
    return side_at(ends_there ? piece.points.front() : piece.points.back(), x);
}

// At a node, left or right of the two pieces that meet there; beside a tip, like the nodes of its element (a kink may
// put them across the straight line behind the tip); along an edge.
void CrackSides::put_on_elements(std::span<const Tip> tips, std::vector<signed char>& sides) const {
    for (const int node : on_crack_) {
        for (const int element : mesh_.around()[at(node)]) {
            if (cut_.contains(element)) continue;
            const int side = side_at(mesh_->nodes[at(node)], centre(*mesh_, element));
            if (known_sides(element).contains(-side)) continue;  // ahead of a tip
            sides[at(element)] = static_cast<signed char>(side);
        }
    }
    if (path_.tip_at_start) put_beside_tip(path_.pieces.front(), tips.front(), sides);
    if (path_.tip_at_end) put_beside_tip(path_.pieces.back(), tips.back(), sides);
    for (const CrackPiece& piece : path_.pieces) {
        if (piece.neighbour < 0) continue;  // of the element into which the crack leaves its edge both sides are there
        if (!cut_.contains(piece.element)) sides[at(piece.element)] = -1;
        if (!cut_.contains(piece.neighbour)) sides[at(piece.neighbour)] = 1;
    }
}

std::set<int> CrackSides::known_sides(int element) const {
    std::set<int> known;
    for (const int node : mesh_->elements[at(element)])
        if (of_nodes_.contains(node) && !on_crack_.contains(node)) known.insert(of_nodes_.at(node));
    return known;
}

void CrackSides::put_beside_tip(const CrackPiece& piece, const Tip& tip, std::vector<signed char>& sides) const {
    std::map<int, std::set<int>> seen;  // sides of each element's nodes; both: it lies ahead of the tip
    for (const int node : tip_nodes(mesh_, piece)) {
        if (on_crack_.contains(node)) continue;
        for (const int element : mesh_.around()[at(node)]) seen[element].insert(near_tip(piece, node));
    }
    for (auto& [element, of_its_nodes] : seen) of_its_nodes.merge(known_sides(element));
    for (const auto& [element, of_its_nodes] : seen) {
        signed char& known = sides[at(element)];
        const int side = *of_its_nodes.begin();
        if (known != 0 || of_its_nodes.size() > 1 || cut_.contains(element) || is_torn(element, tip, side)) continue;
        known = static_cast<signed char>(side);
    }
}

// Seen from a tip outside it an element spans less than half a turn; more where the branch of theta changes inside it.
bool CrackSides::is_torn(int element, const Tip& tip, int side) const {
    double least = 1e300, most = -1e300;
    for (const Vec2& corner : corners_of_element(*mesh_, element)) {
        const double theta = tip_polar(tip, corner, side).theta;
        least = std::min(least, theta);
        most = std::max(most, theta);
    }
    return most - least > 1.001 * std::numbers::pi;
}

// The line behind the tip, from a crack that has turned.
bool CrackSides::lies_across(int element, const Tip& tip, int side) const {
    return std::ranges::any_of(corners_of_element(*mesh_, element), [&](const Vec2& corner) {
        return std::abs(tip_polar(tip, corner, side).theta - tip_polar(tip, corner, 0).theta) > std::numbers::pi;
    });
}

/// The crack's points before and after one of its points; beyond an end its line goes on.
std::pair<Vec2, Vec2> CrackSides::neighbours_on_crack(const Vec2& x) const {
    std::optional<Vec2> before, after;
    for (const CrackPiece& piece : path_.pieces) {
        if (piece.points.front() == x) after = piece.points[1];
        if (piece.points.back() == x) before = piece.points[piece.points.size() - 2];
    }
    if (!before) before = 2.0 * x - *after;
    if (!after) after = 2.0 * x - *before;
    return {*before, *after};
}

int CrackSides::side_at(const Vec2& bend, const Vec2& x) const {
    const auto [before, after] = neighbours_on_crack(bend);
    return side_of_bend(before, bend, after, x);
}

int CrackSides::of_place(const Vec2& x) const {
    std::size_t nearest = 1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < points_.size(); ++k) {
        const double distance = distance_to_segment(x, points_[k - 1], points_[k]);
        if (distance < least) least = distance, nearest = k;
    }
    const Vec2 &from = points_[nearest - 1], &to = points_[nearest];
    const double along = (x - from).dot(to - from);
    if (along <= 0.0 && nearest > 1) return side_of_bend(points_[nearest - 2], from, to, x);
    if (along >= (to - from).squaredNorm() && nearest + 1 < points_.size())
        return side_of_bend(from, to, points_[nearest + 1], x);
    return orientation(from, to, x) > 0 ? 1 : -1;
}

// An element off the crack lies on one side of it, and so does the branch of theta there: by the line behind the tip it
// would jump inside the element, where nothing is cracked.
void CrackSides::put_behind_tip(const Tip& tip, const std::map<int, int>& nodes,
                                std::vector<signed char>& sides) const {
    std::vector<int> with_functions;
    for (const auto& [node, side] : nodes) with_functions.push_back(node);
    for (const int element : mesh_.elements_about(with_functions)) {
        signed char& known = sides[at(element)];
        if (known != 0 || cut_.contains(element) || !contains_any(nodes, mesh_->elements[at(element)]) ||
            known_sides(element).size() > 1)
            continue;
        const int side = of_place(centre(*mesh_, element));
        if (lies_across(element, tip, side) && !is_torn(element, tip, side)) known = static_cast<signed char>(side);
    }
}

}  // namespace stria::coarse
