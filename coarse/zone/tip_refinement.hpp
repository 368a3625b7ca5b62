// Where the case wants small elements about its tips (fine.refine): when the body is meshed, and as the tips advance.
#pragma once

#include <vector>

#include "coarse/model/mesh_refinement.hpp"
#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// How far small elements lie ahead of a tip.
enum class Room {
    None,   // where cracks grow, as far as metal flows about the tip as it stands
    ToGrow  // and the next steps of growth, so that not each of them splits elements
};

/// One disk per tip: the radius of its zone, and at least the elements about its own, so that tip functions end within
/// the smallest elements where none stays whole. How long the run will be does not show: it may be resumed with more
/// cycles. `cracks`: those of the scene, or longer ones, which the disks follow from the present tips on. `K`: the
/// largest of the load history, one per tip, MPa sqrt(mm).
std::vector<RefinedDisk> disks_about_tips(const Scene& scene, const std::vector<CrackSection>& cracks,
                                          const std::vector<double>& K, Room room);

/// How often the element at a tip would have to be split to be as small as the case asks for.
[[nodiscard]] int levels_missing(const Scene& scene, const Tip& tip);

/// Elements that may be split as the cracks take their next steps straight ahead. `whole`: that never are.
[[nodiscard]] ElementSet elements_to_split_soon(const Scene& scene, const std::vector<double>& K,
                                                const ElementSet& whole);

/// One disk per tip as far as those elements reach that flow and belong to it (coupling/flow_shells.hpp), together with
/// those that have flowed before: there no element is larger than a quarter of its distance from the tip. Flow
/// elsewhere, under a load or at a hole, asks for no small elements.
std::vector<RefinedDisk> disks_about_flow(const Scene& scene, const std::vector<int>& flowing,
                                          const ElementSet& flowed);

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
