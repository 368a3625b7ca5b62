// The rings about each tip over which fracture parameters are integrated, chosen from the geometry alone.
#pragma once

#include <span>
#include <vector>

#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/model/scene.hpp"
#include "common/fracture/ring_weights.hpp"

namespace stria::coarse {

/// Nothing flows, and functions that span the singular fields of elasticity stand at the tips.
bool has_elastic_fields(const Scene& scene);

/// What bounds the rings about a tip, mm.
struct RoomForRings {
    double boundary;
    double bends_and_forces;
    double other_end;     // the other tip of its crack
    double other_cracks;  // and their tips
};
RoomForRings room_for_rings(const Scene& scene, int tip);

/// Outer radius of the largest ring around a tip, mm: within that room, no longer than 40 of the body's
/// longest edges where nothing flows over many of them, and inside the tip's metal, unless that leaves less than four
/// elements.
double largest_ring(const Scene& scene, int tip);

/// The same, or that of its nominal body where that is larger: both must be near, whichever is solved.
double largest_ring_of_either_body(const Scene& scene, int tip);

/// Of the largest one that other metals allow (Materials::are_alike()), mm; infinite where there are none.
double largest_ring_of_one_metal(const Scene& scene, int tip);

/// Elements across the radius of a ring of one metal, off sharp bends: in a smaller one J is off by one percent or
/// more.
inline constexpr double least_for_J = 2.0;

/// So many elements behind a sharp bend J is told: from there on such a ring has room.
inline constexpr double elements_for_J = least_for_J + elements_before_bend;

/// Of the largest ring that J may be told from as far as other metals and sharp bends go, mm: it is not known across
/// metals, nor near the corner of a bend. Infinite where there are none, negative next to a bend.
double largest_ring_for_J(const Scene& scene, int tip);

/// Whether other metals leave a ring that J can be taken in, and whether a sharp bend does.
bool metals_leave_J(const Scene& scene, int tip);
bool bends_leave_J(const Scene& scene, int tip);

/// Concentric rings within the largest one, of one metal all of them or none. The first is the thickest: K is taken
/// there, and J if it may be. Of the others those are left that are at least two elements thick, which also keeps them
/// two elements off the tip's own. Where J is not told from the first, a smaller one for J alone stands in front of
/// them, if it has room.
std::vector<Annulus> rings_about(const Scene& scene, int tip);

/// Place of the first of them that K and T are told from.
std::size_t first_for_K(std::span<const Annulus> rings);

}  // namespace stria::coarse
