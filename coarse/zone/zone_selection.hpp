// Which elements the fine component owns: the disk of eq. (3) around each tip, the cut elements whose faces may touch,
// and whatever carries tip functions.
#pragma once

#include <vector>

#include "coarse/model/scene.hpp"
#include "coupling/messages.hpp"

namespace stria::coarse {

/// Eq. (3): R_sub = beta * (pi/16) * K_I^2 / sigma_y^2, mm.
double subdivision_radius(double beta, double K_I, double yield_stress);

/// Radius of the zone about a tip, mm: the case's own, or eq. (3); 0 in elastic scenes without one.
double zone_radius(const Case& input, double K_I);

/// Per element, 1 inside the zone. `K_I`: largest of the load history, one a tip. All zero in elastic, traction-free
/// scenes.
std::vector<char> select_zone(const Scene& scene, const std::vector<double>& K_I);

/// A zone that some elements join, with one ring of neighbours more, so that a growing plastic zone does not ask again
/// at once.
std::vector<char> with_ring(const Scene& scene, std::vector<char> in_zone, const std::vector<int>& joining);

/// A zone with the elements whose functions longer cracks change: those that they newly cut, or that get tip functions.
std::vector<char> with_changed_functions(std::vector<char> in_zone, const EnrichedMesh& before,
                                         const EnrichedMesh& longer);

/// The zone as the message that the fine component gets; `displacement`: of the whole mesh, committed.
coupling::Patch make_patch(const Scene& scene, const std::vector<char>& in_zone, const std::vector<int>& gamma,
                           const Eigen::VectorXd& displacement);

}  // namespace stria::coarse
