// Which elements of a tree of fronts stand together: by where they lie.
#pragma once

#include <span>
#include <vector>

#include "common/substructure/assembly_tree.hpp"
#include "common/substructure/front_layout.hpp"

namespace stria {

/// Appends a tree of these elements, the root last, with its children and the elements of its leaves and nothing else.
/// It depends on where elements lie, not on their numbers. Where some come or go, most parts of the others stay.
void bisect(const FrontLayout& layout, std::span<int> elements, std::vector<AssemblyTree::Node>& nodes);

/// The number above `low` and not above `high` with the fewest binary digits; low < high.
[[nodiscard]] double roundest_between(double low, double high);

}  // namespace stria
