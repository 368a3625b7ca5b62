// Local refinement: elements split in four, again and again, neighbours never more than twice as large.
#pragma once

#include <vector>

#include "common/fem/mesh.hpp"
#include "common/geometry/vec2.hpp"

namespace stria::coarse {

/// Where small elements are asked for: along the way of a disk's centre elements split `levels` times; away from it an
/// element within `radius` is small enough if its longest edge is at most `growth` times its distance (0: all split
/// alike).
struct RefinedDisk {
    Vec2 from, to;  // of the centre, mm
    double radius;  // mm
    int levels;
    double growth;
};

/// Splits elements of an unsplit mesh as the disks ask, and more of them so that elements which share as much as a
/// corner differ by one level at most: the ends of an edge with a hanging node never hang themselves. Old nodes keep
/// their numbers, the parts of an element take its place, boundary edges and inserts follow.
Mesh refine(Mesh mesh, const std::vector<RefinedDisk>& disks);

}  // namespace stria::coarse
