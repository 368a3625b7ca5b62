// Local refinement: elements split in four, again and again, neighbours never more than twice as large.
#pragma once

#include <vector>

#include "common/fem/body_mesh.hpp"
#include "common/geometry/vec2.hpp"
#include "common/index_set.hpp"

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

/// Elements that were split at once, ascending, time after time; each time by the numbers of the mesh that there was.
using MeshSplits = std::vector<std::vector<int>>;

struct RefinedMesh {
    Mesh mesh;
    MeshSplits splits;
    std::vector<int> part_of;  // per element: that of the mesh before of which it is a part; -1: it was there itself
};

/// Splits elements as the disks ask, and more of them so that elements which share as much as a corner differ by one
/// level at most: the ends of an edge with a hanging node never hang themselves. Nodes and elements keep their numbers;
/// the part at an element's first corner takes its number, the other three come last. Boundary edges and inserts
/// follow. `never`: elements that stay whole, and with them what would need them split (none: empty).
RefinedMesh refine(const BodyMesh& mesh, const std::vector<RefinedDisk>& disks, const ElementSet& never = {});

/// Whether refine() would split anything.
bool asks_for_more(const BodyMesh& mesh, const std::vector<RefinedDisk>& disks, const ElementSet& never);

/// The mesh that came of the same splits before.
Mesh split_again(Mesh mesh, const MeshSplits& splits);

}  // namespace stria::coarse
