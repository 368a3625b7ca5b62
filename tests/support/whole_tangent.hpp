// A condensed tangent with both of its triangles.
#pragma once

#include "common/linear/lower_triangle.hpp"
#include "common/substructure/substructure.hpp"

namespace stria::test {

inline Eigen::MatrixXd whole(CondensedTangent tangent) {
    if (tangent.symmetry == Symmetry::Symmetric) mirror_lower(tangent.matrix);
    return std::move(tangent.matrix);
}

}  // namespace stria::test
