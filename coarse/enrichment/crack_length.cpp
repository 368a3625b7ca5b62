#include "coarse/enrichment/crack_length.hpp"

#include <algorithm>
#include <ranges>

namespace stria::coarse {

double length_in_body(const EnrichedMesh& mesh, int crack) {
    const auto is_its = [&](const CrackPiece& piece) { return piece.crack == crack; };
    double length = std::ranges::find_if(mesh.pieces | std::views::reverse, is_its)->s.back() -
                    std::ranges::find_if(mesh.pieces, is_its)->s.front();
    for (const Tip& tip : mesh.tips)
        if (tip.crack == crack) length += tip.beyond;
    return length;
}

}  // namespace stria::coarse
