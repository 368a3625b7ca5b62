#include "coarse/enrichment/crack_tips.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

#include "coarse/enrichment/tip_support.hpp"
#include "common/index.hpp"
#include "common/index_set.hpp"

namespace stria::coarse {
namespace {

Tip tip_at(const Mesh& mesh, const CrackPath& path, bool start) {
    const CrackPiece& piece = start ? path.pieces.front() : path.pieces.back();
    const std::vector<Vec2>& points = path.points;
    Tip tip;
    tip.crack = piece.crack;
    tip.material = mesh.material_of(piece.element);
    tip.s = start ? piece.s.front() : piece.s.back();
    tip.upper = start ? -1 : 1;
    tip.position = start ? points.front() : points.back();
    tip.beyond = start ? tip.s : path.length - tip.s;
    // Of the crack as given: the last piece may be short, and its other end snapped onto a node.
    const Vec2& before = start ? points[1] : points[points.size() - 2];
    tip.direction = (tip.position - before).normalized();
    return tip;
}

}  // namespace

std::vector<Tip> tips_of(const Mesh& mesh, const CrackPath& path) {
    std::vector<Tip> tips;
    if (path.tip_at_start) tips.push_back(tip_at(mesh, path, true));
    if (path.tip_at_end) tips.push_back(tip_at(mesh, path, false));
    return tips;
}

const CrackPiece& last_piece(const CrackPath& path, const Tip& tip) {
    return tip.upper < 0 ? path.pieces.front() : path.pieces.back();
}

void require_behind(const Mesh& mesh, const CrackPath& path, const Tip& tip) {
    const CrackPiece& piece = last_piece(path, tip);
    const std::vector<Vec2>& points = piece.points;
    const Vec2 into = tip.upper < 0 ? Vec2(points[points.size() - 2] - points.back()) : Vec2(points[1] - points[0]);
    const std::set<int> holders = tip_nodes(mesh, piece);
    const auto is_ahead = [&](const Vec2& x) {
        return (x - tip.position).dot(tip.direction) > 1e-9 * (x - tip.position).norm();
    };
    const auto hooks = [&](const CrackPiece& other) {
        return contains_any(holders, mesh.elements[at(other.element)]) && std::ranges::any_of(other.points, is_ahead);
    };
    if (into.dot(tip.direction) >= 0.0 && std::ranges::none_of(path.pieces, hooks)) return;
    throw CrackOffMesh(fmt::format("crack {}: it turns by more than 90 degrees within two elements of its tip at "
                                   "({:.6g}, {:.6g}); use smaller elements there",
                                   tip.crack, tip.position.x(), tip.position.y()));
}

}  // namespace stria::coarse
