// What the tree of a zone is made of: its elements, then its multipliers.
#pragma once

#include <vector>

#include "common/substructure/front_tree.hpp"
#include "fine/zone/zone_system.hpp"

namespace stria::fine {

[[nodiscard]] FrontTree::Layout layout_of_tree(const ZoneSystem& system);

/// The centres of the elements that hold the tips: while a tip stays in its element the tree stays as it is.
[[nodiscard]] std::vector<Vec2> busy_places(const EnrichedMesh& mesh);

}  // namespace stria::fine
