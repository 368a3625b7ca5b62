// How far around a tip its asymptotic field is the whole story.
#pragma once

#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "common/case/case.hpp"
#include "common/enrichment/enriched_mesh.hpp"
#include "common/fem/mesh.hpp"
#include "common/material/materials.hpp"

namespace stria::coarse {

/// A bend that leaves the tip's line by less than this times its element's diagonal is none that the mesh could show.
constexpr double bend_to_element = 0.25;

/// From so many elements behind a bend on K is resolved: rings about a tip pass over one that is nearer.
constexpr double elements_behind_bend = 2.0;

/// A turn by more than ten degrees is sharp: K of a tip just behind it is not resolved, and what is turned so much from
/// the line behind a tip begins at a sharp bend, if the mesh could show it.
constexpr double sharp_turn = std::numbers::pi / 18.0;

/// Rings for J end so many elements before a sharp bend: J is quadratic in the singular field of its corner, which the
/// elements about it do not hold (docs/verification/elastic.md, "J behind a bend").
constexpr double elements_before_bend = 2.0;

/// Half of the distance from tip number `tip` to the other one of its crack, mm; infinite where there is none.
double half_way_to_other_end(std::span<const Tip> tips, int tip);

/// The same to the nearest other crack, its tips included.
double half_way_to_other_cracks(const std::vector<CrackSection>& cracks, std::span<const Tip> tips, int tip);

/// Distance from a tip to what its own crack is beyond the place where it leaves the line behind the tip by more than
/// `band`, mm; infinite where it does not.
double distance_to_bend(const std::vector<CrackSection>& cracks, const Tip& tip, double band);

/// The first sharp bend of a tip's crack, seen from the tip.
struct SharpBend {
    double distance;  // from the tip to what the crack is from there on, mm
    double element;   // edge of the element that holds it, mm
};
std::optional<SharpBend> sharp_bend(const EnrichedMesh& mesh, const std::vector<CrackSection>& cracks, const Tip& tip);

/// Distance from a tip to the nearest of a bend and the body's boundary, mm.
double room_in_body(const Mesh& mesh, const std::vector<CrackSection>& cracks, const Tip& tip, double band);

/// Distance from a tip to that place; infinite where the crack does not leave the line.
double straight_length(const CrackSection& crack, const Tip& tip, double band);

/// Distance from a tip to the nearest element of a material that is not like its own (Materials::are_alike()), mm;
/// infinite where there is none.
double distance_to_interface(const EnrichedMesh& mesh, const Materials& materials, const Tip& tip);

/// mm.
double distance_to_boundary(const Mesh& mesh, const Vec2& x);

/// How far a tip can go straight on until it meets the boundary, mm.
double way_to_boundary(const Mesh& mesh, const Tip& tip);

/// Diagonal of the element that holds a tip, mm; 0: the mesh has none of its crack.
double tip_element_size(const EnrichedMesh& mesh, const Tip& tip);

/// Edge of a square of that diagonal, mm.
double tip_element_edge(const EnrichedMesh& mesh, const Tip& tip);

/// How long it is along the crack, mm: by so much the tip goes from one element to the next.
double tip_element_along(const EnrichedMesh& mesh, const Tip& tip);

}  // namespace stria::coarse
