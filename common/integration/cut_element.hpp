// The two sides of an element that a crack cuts: polygons left (plus) and right (minus) of it.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "common/enrichment/enriched_mesh.hpp"

namespace stria {

struct CutElement {
    std::vector<Vec2> left, right;                    // counter-clockwise; left of the crack's points is the plus side
    std::vector<std::pair<Vec2, Vec2>> segments;      // the crack inside the element
    std::vector<std::pair<Vec2, Vec2>> continuation;  // from tips straight on to the element's boundary: no jump there
    std::vector<Vec2> tips;                           // ends inside the element

    /// Side of a point off the crack: +1 left, -1 right. Decided by exact predicates.
    [[nodiscard]] int side_of(const Vec2& x) const;
};

/// `piece` must lie inside the element (not along an edge).
CutElement cut_element(const std::array<Vec2, 4>& corners, const CrackPiece& piece);

/// Cuts the crack's piece where it crosses the lines of an s x s grid of sub-quadrangles (Fig. 2): the interface
/// elements, as consecutive points along the piece with their arc lengths.
struct InterfacePoints {
    std::vector<Vec2> points;
    std::vector<double> s;
};
InterfacePoints interface_elements(const std::array<Vec2, 4>& corners, const CrackPiece& piece, int subcells);

/// Corner (i, j) of the s x s grid of sub-quadrangles, 0 <= i, j <= s.
Vec2 grid_corner(const std::array<Vec2, 4>& corners, int subcells, int i, int j);

}  // namespace stria
