// The length of cracks that is reported, and whether it leaves them a way to grow.
#pragma once

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// a of a tip, mm: from the load line where the specimen has one; else arc length from the mouth, or half of it with
/// two tips (docs/method.md, section 9).
[[nodiscard]] double reported_length(const Scene& scene, const Tip& tip);

/// Along the crack to a tip, mm, from a point that growth does not move: it changes by what the tip goes, around a bend
/// too, and by nothing where only the other tip goes, to rounding.
[[nodiscard]] double way_to_tip(const Scene& scene, const Tip& tip);

/// Throws CaseError, naming the tip, where a crack is as long as growth.until asks before it has grown.
void require_way_to_grow(const Scene& scene);

}  // namespace stria::coarse
