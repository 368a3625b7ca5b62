// Loads that act where displacements hold the body: supports bear them, and nothing else feels them.
#pragma once

#include <vector>

#include "common/case/case.hpp"
#include "common/fem/mesh.hpp"

namespace stria::coarse {

/// Throws CaseError where all that one of the sections loads is held along its load, be it by another section.
void require_free_places(const Mesh& mesh, const std::vector<BoundarySection>& sections);

}  // namespace stria::coarse
