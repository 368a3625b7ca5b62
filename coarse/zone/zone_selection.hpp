// Which elements the fine component owns: the disk of eq. (3) around each tip, the cut elements whose faces may touch,
// and whatever carries tip functions.
#pragma once

#include <vector>

#include "coarse/model/scene.hpp"
#include "common/index_set.hpp"
#include "coupling/messages.hpp"

namespace stria::coarse {

/// Radius of the zone about a tip, mm: that of the case, or eq. (3). 0 without either. `yield_stress`: at the tip, MPa;
/// infinite where nothing yields.
double zone_radius(const FineSection& fine, double yield_stress, double K);

/// Takes in the cut elements whose faces may touch: of a crack along an edge those on both sides.
void add_touching_faces(const Scene& scene, ElementSet& elements);

/// The elements of the zone. `K`: the largest of the load history, MPa sqrt(mm), one per tip. None in elastic,
/// traction-free scenes.
ElementSet select_zone(const Scene& scene, const std::vector<double>& K);

/// What K is expected to be at most after a step of growth: it grows with the cracks.
std::vector<double> expected_K(std::vector<double> K);

/// A zone that some elements join together with their neighbours. The neighbours give a growing plastic zone room, so
/// that it does not ask again at once.
ElementSet with_ring(const Scene& scene, ElementSet in_zone, const std::vector<int>& joining);

/// A zone that takes in the elements whose functions longer cracks change: those that they newly cut, and those that
/// get tip functions.
ElementSet with_changed_functions(ElementSet in_zone, const EnrichedMesh& before, const Scene& longer);

/// Elements of a zone in which points yield, from how many do in each, ascending; none where nobody tells.
ElementSet flowing_in(const ElementSet& zone, const std::vector<std::int32_t>& yielding_points);

/// The message by which the fine component gets its zone. `displacement`: of the whole mesh, committed, mm.
coupling::Patch make_patch(const Scene& scene, const ElementSet& in_zone, const std::vector<int>& gamma,
                           const Eigen::VectorXd& displacement);

}  // namespace stria::coarse
