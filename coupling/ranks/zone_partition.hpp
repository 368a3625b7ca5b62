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
/// bisected by centres into parts of about equal work. Where there are more ranks than can be used, the last
/// have no element. `flow`: as in heaviest_share().
std::vector<int> share_out(const EnrichedMesh& zone, int ranks, const EnrichedMesh& before = {},
                           const std::vector<int>& part_of = {}, const std::vector<double>& flow = {});

/// The same where elements have a rank already, by id in `owners`, and keep it, for their history lives there; parts
/// have that of their whole; what is new joins a neighbour's rank. Nothing where elements of several ranks have to come
/// together.
std::optional<std::vector<int>> share_on(const EnrichedMesh& zone, const std::map<int, int>& owners,
                                         const std::vector<int>& part_of = {});

/// What the rank with most to do has to do, of an equal share. `flow`: of each element, the part of the iterations in
/// which it yields; empty: nothing is known. An element that yields costs much more than one that does not.
double heaviest_share(const std::vector<int>& rank_of_element, int ranks, const std::vector<double>& flow);

}  // namespace stria::coupling
