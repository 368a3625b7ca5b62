#include "fine/material/implicit/return_law.hpp"

#include "common/material/linear_hardening.hpp"

namespace stria::fine {

ReturnLaw::ReturnLaw(const J2Parameters& parameters, const Eigen::Array3d& elastic_rates)
    : has_thresholds(parameters.has_thresholds()), rates(elastic_rates),
      first_rates(elastic_rates + 2.0 / 3.0 * parameters.prager_modulus()) {
    int first = state::back_stress;
    for (const KinematicHardening& term : parameters.kinematic) {
        if (is_linear(term)) {
            linear.push_back(first);
            linear_C.push_back(term.C);
            rates += 2.0 / 3.0 * term.C;
        } else {
            back_stresses.push_back(first);
            recalling.push_back(term);
        }
        first += 4;
    }
}

}  // namespace stria::fine
