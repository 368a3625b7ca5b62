#include "common/integration/cut_element.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/geometry/clipping.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

struct BoundaryHit {
    Vec2 point;
    double place;
};

/// Where the ray from a tip inside the element leaves it.
BoundaryHit leave(const std::array<Vec2, 4>& corners, const Vec2& tip, const Vec2& direction) {
    const double reach = 4.0 * ((corners[2] - corners[0]).norm() + (corners[3] - corners[1]).norm());
    BoundaryHit best{tip, -1.0};
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 &a = corners[k], &b = corners[(k + 1) % 4];
        const auto hit = intersect(tip, tip + reach * direction, a, b);
        if (!hit || (best.place >= 0.0 && (hit->second - tip).norm() <= (best.point - tip).norm())) continue;
        const double t = std::clamp((hit->second - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        best = {hit->second, std::fmod(static_cast<double>(k) + t, 4.0)};
    }
    require(best.place >= 0.0, "a ray from inside an element leaves it");
    return best;
}

/// Corners strictly between two places of the boundary, counter-clockwise.
void append_corners(std::vector<Vec2>& polygon, const std::array<Vec2, 4>& corners, double from, double to) {
    if (to < from) to += 4.0;
    for (int k = static_cast<int>(std::floor(from)) + 1; k < to; ++k) polygon.push_back(corners[at(k % 4)]);
}

}  // namespace

int CutElement::side_of(const Vec2& x) const { return side_of_polygon(left, x) > 0 ? 1 : -1; }

CutElement cut_element(const std::array<Vec2, 4>& corners, const CrackPiece& piece) {
    CutElement cut;
    std::vector<Vec2> chain = piece.points;
    double entry = piece.entry, exit = piece.exit;
    for (std::size_t k = 0; k + 1 < piece.points.size(); ++k)
        cut.segments.emplace_back(piece.points[k], piece.points[k + 1]);
    if (entry < 0.0) {
        const BoundaryHit hit = leave(corners, chain[0], (chain[0] - chain[1]).normalized());
        cut.tips.push_back(chain[0]);
        cut.continuation.emplace_back(hit.point, chain[0]);
        chain.insert(chain.begin(), hit.point);
        entry = hit.place;
    }
    if (exit < 0.0) {
        const Vec2 tip = chain.back();
        const BoundaryHit hit = leave(corners, tip, (tip - chain[chain.size() - 2]).normalized());
        cut.tips.push_back(tip);
        cut.continuation.emplace_back(tip, hit.point);
        chain.push_back(hit.point);
        exit = hit.place;
    }
    cut.left = chain;
    append_corners(cut.left, corners, exit, entry);
    cut.right.assign(chain.rbegin(), chain.rend());
    append_corners(cut.right, corners, entry, exit);
    return cut;
}

Vec2 grid_corner(const std::array<Vec2, 4>& corners, int subcells, int i, int j) {
    return map_to_physical(corners, Vec2(-1.0 + 2.0 * i / subcells, -1.0 + 2.0 * j / subcells));
}

InterfacePoints interface_elements(const std::array<Vec2, 4>& corners, const CrackPiece& piece, int subcells) {
    InterfacePoints result;
    const double tiny = 1e-9 * (piece.s.back() - piece.s.front());
    for (std::size_t k = 0; k + 1 < piece.points.size(); ++k) {
        const Vec2 &a = piece.points[k], &b = piece.points[k + 1];
        std::vector<double> breaks{piece.s[k], piece.s[k + 1]};
        const auto cut_by = [&](const Vec2& c, const Vec2& d) {
            const auto hit = intersect(a, b, c, d);
            if (!hit) return;
            for (const Vec2& x : {hit->first, hit->second})
                breaks.push_back(std::clamp(piece.s[k] + (x - a).norm(), piece.s[k], piece.s[k + 1]));
        };
        for (int line = 1; line < subcells; ++line) {
            cut_by(grid_corner(corners, subcells, line, 0), grid_corner(corners, subcells, line, subcells));
            cut_by(grid_corner(corners, subcells, 0, line), grid_corner(corners, subcells, subcells, line));
        }
        std::ranges::sort(breaks);
        for (const double s : breaks) {
            if (!result.s.empty() && s - result.s.back() <= tiny) continue;
            result.s.push_back(s);
            result.points.push_back(a + (s - piece.s[k]) / (piece.s[k + 1] - piece.s[k]) * (b - a));
        }
    }
    return result;
}

}  // namespace stria
