// Which fine rank owns which element of the zone.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "common/enrichment/enriched_mesh.hpp"

namespace stria::coupling {

/// The rank of each element. Elements that see jump or tip unknowns of a crack, or carry pieces of it, stay together:
/// contact, multipliers and tip functions live with one rank. So do those around a hanging node: the ends of its edge
/// come with them. And so do those of which that is true in `before`, the zone that it was (empty: none), for history
/// moves under it. So do the parts of an element that has been split: `part_of` as in Patch. What is left to choose is
/// bisected by centres so that an iteration costs least (cost_of_sharing). Where there are more ranks than can be used,
/// the last have no element. `flow`: as in cost_of_sharing().
std::vector<int> share_out(const EnrichedMesh& zone, int ranks, const EnrichedMesh& before = {},
                           const std::vector<int>& part_of = {}, const std::vector<double>& flow = {});

/// The same where elements have a rank already, by id in `owners`, and keep it, for their history lives there; parts
/// have that of their whole; what is new joins a neighbour's rank. Nothing where elements of several ranks have to come
/// together.
std::optional<std::vector<int>> share_on(const EnrichedMesh& zone, const std::map<int, int>& owners,
                                         const std::vector<int>& part_of = {});

/// What an iteration costs while ranks wait for each other and are merged, in units of an element that does not yield.
/// `flow`: of each element, the part of the iterations in which it yields; empty: nothing is known.
double cost_of_sharing(const EnrichedMesh& zone, const std::vector<int>& rank_of_element,
                       const std::vector<double>& flow);

}  // namespace stria::coupling
