// The end of a crack at which a tip is.
#pragma once

#include <span>
#include <vector>

#include "common/case/case.hpp"
#include "common/crack/crack_piece.hpp"
#include "common/crack/tip.hpp"
#include "common/geometry/vec2.hpp"

namespace stria {

// The crack may be longer than it was when the tip was found: what is asked for is its end as it stands.

/// The points of a crack in the order that leads to a tip, mm: its end there comes last.
std::vector<Vec2> points_to(const CrackSection& crack, const Tip& tip);

/// The end itself, mm.
Vec2 end_of(const CrackSection& crack, const Tip& tip);

/// From the last corner, or the crack's other end, to the end at a tip, mm.
Vec2 last_stretch(const CrackSection& crack, const Tip& tip);

/// The unit vector in which the crack gets there.
Vec2 direction_of_end(const CrackSection& crack, const Tip& tip);

/// The piece that holds a tip or, where the faces end on an element edge, the last one before that edge. Null: none of
/// the pieces, which lie in the order of their cracks, is of the tip's crack.
const CrackPiece* piece_of(std::span<const CrackPiece> pieces, const Tip& tip);

}  // namespace stria
