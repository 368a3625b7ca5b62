// What equilibrium has left of the initial stress.
#pragma once

#include <functional>
#include <string>

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// Notes which share of its energy is left. `stored`: in equilibrium without load, N. Throws CaseError where little is
/// left of a field that the case gives as self-equilibrated: it was not.
void judge_settled_stress(const Scene& scene, double stored, const std::function<void(const std::string&)>& note);

}  // namespace stria::coarse
