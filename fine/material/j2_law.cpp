#include "fine/material/j2_law.hpp"

#include "fine/material/j2_pack.hpp"

namespace stria::fine {

void J2Law::update(int points, int stride, const double* strain_increment, const double* committed, double* trial,
                   double* tangent, unsigned char* yielding) const {
    return_points({.law = parameters_,
                   .stiffness = elastic(),
                   .strain_increment = strain_increment,
                   .committed = committed,
                   .trial = trial,
                   .tangent = tangent,
                   .yielding = yielding},
                  points, stride);
}

}  // namespace stria::fine
