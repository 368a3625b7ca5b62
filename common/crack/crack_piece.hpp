// What one element sees of a crack.
#pragma once

#include <vector>

#include "common/geometry/vec2.hpp"

namespace stria {

/// Part of a crack inside one element, as resolved on the mesh (crossings within 1e-3 of an edge's length of a node are
/// snapped onto the node). Runs from one element boundary point to another, or ends at a tip inside the element.
struct CrackPiece {
    int crack;
    int element;         // index into EnrichedMesh::elements
    int neighbour = -1;  // the other element where the piece runs along an edge (element lies right of it), else -1
    std::vector<Vec2> points;  // in the order of the crack's points, kinks included, mm
    std::vector<double> s;     // arc length of each point from the crack's first point
    double entry = -1.0;  // place on the element's boundary, edge index + fraction of it; -1: starts at a tip inside
    double exit = -1.0;   // likewise for its last point
};

}  // namespace stria
