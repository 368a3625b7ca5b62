// Limit loads: advice where no equilibrium is found, and where one is beyond all that small strains can tell.
#pragma once

#include <string>

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// Where forces drive a body that yields, its limit load may be what is in the way; else empty. Goes on a sentence.
/// `moved`: its loaded boundary, mm.
std::string limit_load_hint(const Scene& scene, double moved);

/// How far the loaded boundary of such a body moves at most, mm, while displacements are small; else infinite.
double gives_way_at(const Scene& scene);

}  // namespace stria::coarse
