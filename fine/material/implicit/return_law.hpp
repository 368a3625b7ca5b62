// What of a law of J2 plasticity its implicit return meets.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fine/material/implicit/plane_deviators.hpp"
#include "fine/material/j2_parameters.hpp"

namespace stria::fine {

/// Prager's back stresses are in proportion to the plastic strain, as what it takes of the stress is: the return
/// follows the stress less all of them. The others forget, or their C changes: they are followed one by one.
struct ReturnLaw {
    ReturnLaw(const J2Parameters& parameters, const Eigen::Array3d& elastic_rates);

    std::vector<double> linear_C;               // MPa
    std::vector<int> linear, back_stresses;     // where in the state a linear one begins, and a recalling one
    std::vector<KinematicHardening> recalling;  // as back_stresses
    bool has_thresholds;
    Eigen::Array3d rates;        // MPa, on the three deviators, the last two of which are alike: see lost()
    Eigen::Array3d first_rates;  // MPa: likewise, with all back stresses, as long as nothing is recalled

    /// What a plastic strain takes of the stress less Prager's back stresses, MPa.
    template <int rows> [[nodiscard]] Deviators<rows> lost(const Deviators<rows>& plastic) const {
        Deviators<rows> result;
        for (int i = 0; i < 3; ++i) result.col(i) = rates[i] * plastic.col(i);
        return result;
    }
};

}  // namespace stria::fine
