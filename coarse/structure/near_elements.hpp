// Which coarse elements are near. Each increment looks at these; of the others, the far ones, it asks for no more than
// a proof that they stay elastic (far_stress_bound.hpp), so that its cost does not know how large the body is. Far ones
// are condensed once and serve structure after structure (far_body.hpp).
#pragma once

#include <vector>

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// Per element, 1 where it has to be near: it is coarse and a ring about a tip crosses or encloses it, it touches the
/// zone, or a crack changes its functions: what the domain integrals and openings want, where stresses are large, and
/// where points with little weight lie.
std::vector<char> near_elements(const Scene& scene, const std::vector<char>& in_zone);

/// Per element, 1 where it is far. `known`: those of the structure before (none: empty); they stay for as long as none
/// of them has to be near. Else they are chosen anew, where cracks grow with room ahead of their tips.
std::vector<char> far_elements(const Scene& scene, const std::vector<char>& in_zone,
                               const std::vector<char>& known = {});

}  // namespace stria::coarse
