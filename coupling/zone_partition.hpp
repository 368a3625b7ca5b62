// Which fine rank owns which element of the zone.
#pragma once

#include <map>
#include <vector>

#include "common/fem/enriched_mesh.hpp"

namespace stria::coupling {

/// The rank of each element. Elements that see jump or tip unknowns of a crack, or carry pieces of it, stay together:
/// contact, multipliers and tip functions live with one rank. So do those around a hanging node: the ends of its edge
/// come with them. What is left to choose is bisected by centres into parts of about equally many elements.
/// Where there are more ranks than can be used, the last have no element.
std::vector<int> share_out(const EnrichedMesh& zone, int ranks);

/// The rank of each element where those of `before` have one already, by id in `owners`. They keep it, for their
/// history lives there, and what is new joins a neighbour's rank. But what a longer crack ties together, and what was
/// tied together before, goes to the rank that has most of it: the history of the others has to move.
std::vector<int> share_on(const EnrichedMesh& zone, const EnrichedMesh& before, const std::map<int, int>& owners);

}  // namespace stria::coupling
