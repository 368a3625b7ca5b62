// Where the case wants small elements about its tips (fine.refine): when the body is meshed, and as the tips advance.
#pragma once

#include <vector>

#include "coarse/model/mesh_refinement.hpp"
#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// How far small elements lie ahead of a tip.
enum class Room {
    None,   // those about the tip as it stands
    ToGrow  // where cracks grow, the next steps of it too, so that not each of them splits elements
};

/// One disk per tip: the radius of its zone, and at least the elements about its own, so that tip functions end within
/// the smallest elements. How long the run will be does not show: it may be resumed with more cycles. `K_I`: the
/// largest of the load history, one per tip, MPa sqrt(mm).
std::vector<RefinedDisk> disks_about_tips(const Scene& scene, const std::vector<double>& K_I, Room room);

/// Elements whose functions an exact copy on their parts cannot be made of: those that see tip functions, hold a tip,
/// or have faces that may touch.
ElementSet elements_with_more_than_jumps(const Scene& scene);

/// A scene on smaller elements, with the cracks as they are.
struct FinerScene {
    Scene scene;
    MeshSplits splits;
    std::vector<int> part_of;  // RefinedMesh
};

}  // namespace stria::coarse
