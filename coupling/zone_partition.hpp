// Which fine rank owns which element of the zone.
#pragma once

#include <map>
#include <vector>

#include "common/fem/enriched_mesh.hpp"

namespace stria::coupling {

/// The rank of each element. Elements that see jump or tip unknowns of a crack, or carry pieces of it, stay together:
/// contact, multipliers and tip functions live with one rank. So do those around a hanging node: the ends of its edge
/// come with them. What is left to choose is bisected by centres into parts of about equally many elements.
/// `owners`: rank by id of elements that have one; they keep it, for their history lives there, and what is new joins
/// a neighbour's rank. Where there are more ranks than can be used, the last have no element. Throws CaseError where
/// history would have to move.
std::vector<int> share_out(const EnrichedMesh& zone, int ranks, const std::map<int, int>& owners);

}  // namespace stria::coupling
