#include "common/crack/crack_end.hpp"

#include <algorithm>

namespace stria {

std::vector<Vec2> points_to(const CrackSection& crack, const Tip& tip) {
    std::vector<Vec2> way = crack.points;
    if (tip.upper < 0) std::ranges::reverse(way);
    return way;
}

Vec2 end_of(const CrackSection& crack, const Tip& tip) {
    return tip.upper > 0 ? crack.points.back() : crack.points.front();
}

Vec2 last_stretch(const CrackSection& crack, const Tip& tip) {
    const Vec2& before = tip.upper > 0 ? crack.points.end()[-2] : crack.points[1];
    return end_of(crack, tip) - before;
}

Vec2 direction_of_end(const CrackSection& crack, const Tip& tip) { return last_stretch(crack, tip).normalized(); }

const CrackPiece* piece_of(std::span<const CrackPiece> pieces, const Tip& tip) {
    const CrackPiece* last = nullptr;
    for (const CrackPiece& piece : pieces) {
        if (piece.crack != tip.crack) continue;
        last = &piece;
        if (tip.upper < 0) break;
    }
    return last;
}

}  // namespace stria
