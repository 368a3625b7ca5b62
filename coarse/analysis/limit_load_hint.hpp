// Advice where no equilibrium is found: the body may have come to its limit load.
#pragma once

#include <string>

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// Where forces drive a body that yields, its limit load may be what is in the way; else empty. Goes on a sentence.
/// `moved`: its loaded boundary, mm.
std::string limit_load_hint(const Scene& scene, double moved);

}  // namespace stria::coarse
