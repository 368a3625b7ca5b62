// Rows and columns of a structured mesh that a crack may not lie on.
#pragma once

#include <vector>

#include "common/case/case.hpp"
#include "common/fem/mesh.hpp"

namespace stria::coarse {

/// A crack that runs along a row or column of element edges and bends between two nodes would end in the middle of an
/// edge. Such a line moves by a quarter of the way to the next one; all others stay.
void move_off_bends(Mesh& mesh, const std::vector<CrackSection>& cracks);

}  // namespace stria::coarse
