#include "fine/material/j2_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/material/linear_hardening.hpp"
#include "fine/material/point_pack.hpp"

namespace stria::fine {

double J2Parameters::prager_modulus() const {
    double sum = 0.0;
    for (const KinematicHardening& term : kinematic) sum += term.C;
    return sum;
}

bool J2Parameters::is_linear() const { return isotropic.linear() != nullptr && are_linear(kinematic); }

bool J2Parameters::has_thresholds() const {
    return std::ranges::any_of(kinematic, [](const KinematicHardening& term) { return term.threshold; });
}

double J2Parameters::elastic_margin(int points, int stride, const double* states) const {
    double margin = std::numeric_limits<double>::infinity();
    for_each_pack<pack_size>(points, stride, [&]<int rows>(PackPlace<rows> at) {
        Tensors<rows> relative = deviators<rows>(at.tensors(states, state::stress));
        for (std::size_t k = 0; k < kinematic.size(); ++k)
            relative -= at.tensors(states, state::back_stress + 4 * static_cast<int>(k));
        const Scalars<rows> equivalent = (1.5 * contraction<rows>(relative, relative)).sqrt();
        const Scalars<rows> p = at.scalars(states, state::accumulated);
        const Scalars<rows> left = (1.0 + overstress_tolerance) * (yield_stress + isotropic.value(p)) - equivalent;
        margin = std::min(margin, left.minCoeff());
    });
    return margin;
}

double J2Parameters::stored_energy(const double* state, int stride) const {
    const double p = state[static_cast<std::ptrdiff_t>(state::accumulated) * stride];
    double energy = elasticity.energy(tensor_at(state, stride, state::stress)) + isotropic.stored(p);
    for (std::size_t k = 0; k < kinematic.size(); ++k) {
        const Mandel X = tensor_at(state, stride, state::back_stress + 4 * static_cast<int>(k));
        if (kinematic[k].C > 0.0) energy += 0.75 * X.squaredNorm() / modulus(kinematic[k], p);
    }
    return energy;
}

}  // namespace stria::fine
