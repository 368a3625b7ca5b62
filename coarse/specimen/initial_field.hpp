// Whether the initial stress that a case gives can be one.
#pragma once

#include "common/case/case.hpp"
#include "common/fem/mesh.hpp"

namespace stria::coarse {

/// Throws CaseError where a profile or a grid does not cover the body, and where a profile has a resultant or a moment
/// over it beyond 2 % of what its amount alone would have: such a stress needs a load to hold it.
void check_initial_stress(const InitialStressSection& given, const Mesh& mesh);

}  // namespace stria::coarse
