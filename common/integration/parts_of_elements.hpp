// The displacement of a mesh on one whose elements are parts of its elements.
#pragma once

#include <vector>

#include "common/integration/element_field.hpp"

namespace stria {

/// An unknown at a corner of parts, that of the component x, and what it is of the unknowns of the wholes.
struct PartUnknown {
    int unknown;
    Shares of_whole;
};

/// Of the standard and Heaviside unknowns at the corners of parts: what the displacement of the wholes is there, on
/// either side of a crack, so that it is the same field. `part_of`: per element of `to`, the id of the element of
/// `from` of which it is a part, -1 where it is none; empty: no element has been split. Parts of elements that `from`
/// does not have are left out. Elements with tip functions must not have been split.
std::vector<PartUnknown> unknowns_of_parts(const EnrichedMesh& from, const EnrichedMesh& to,
                                           const std::vector<int>& part_of);

/// `initial`, of all unknowns of `to`, with their values put in.
Eigen::VectorXd on_parts(const EnrichedMesh& from, const Eigen::VectorXd& values, const EnrichedMesh& to,
                         const std::vector<int>& part_of, Eigen::VectorXd initial);

}  // namespace stria
