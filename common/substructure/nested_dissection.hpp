// An order of elimination for a large plane structure, from where its elements lie: no search in the graph.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "common/geometry/vec2.hpp"
#include "common/index_lists.hpp"

namespace stria {

/// Elements are parted by their centres down to pairs, where both parts share few unknowns and neither is much smaller
/// than the other; an unknown is eliminated as soon as all its elements are in one part, so that what both parts of it
/// share comes after them. `kept`: unknowns that come last, in this order;
/// -1 in the lists: no unknown. `late`: per element, 1 where all its unknowns come after those of other elements alone
/// (empty: nowhere).
/// Returns the unknowns that some element holds, in order of elimination. Time n log^2 n.
std::vector<int> nested_dissection(const IndexLists& element_unknowns, const std::vector<Vec2>& centres, int unknowns,
                                   const std::vector<int>& kept, const std::vector<char>& late = {});

}  // namespace stria
