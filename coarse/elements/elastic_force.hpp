// Forces of an elastic element from its stresses: no rounding of K u where u is mostly rigid motion.
#pragma once

#include "common/mandel.hpp"

namespace stria::coarse {

/// `u`: element values.
template <class Operator, class Values>
Values elastic_force(const Operator& op, const Values& u, const MandelMatrix& elastic) {
    Values force = Values::Zero(u.size());
    for (std::size_t q = 0; q < op.points.size(); ++q) op.add_force(elastic * op.strain(u, q), q, force);
    return force;
}

}  // namespace stria::coarse
