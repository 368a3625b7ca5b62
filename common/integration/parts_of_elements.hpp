// The displacement of a mesh on one whose elements are parts of its elements.
#pragma once

#include <vector>

#include "common/enrichment/enriched_mesh.hpp"

namespace stria {

/// Values of the unknowns at the corners of parts: standard and Heaviside terms take what the displacement of the whole
/// was there, on either side of a crack, so that it is the same field. Elsewhere `initial`. `part_of`: per element of
/// `to`, the id of the element of `from` of which it is a part, -1 where it is none; empty: no element has been split.
/// Parts of elements that `from` does not have are left alone. Elements with tip functions must not have been split.
Eigen::VectorXd on_parts(const EnrichedMesh& from, const Eigen::VectorXd& values, const EnrichedMesh& to,
                         const std::vector<int>& part_of, Eigen::VectorXd initial);

}  // namespace stria
