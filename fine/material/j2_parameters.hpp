// Parameters of J2 plasticity with linear isotropic hardening and Prager back stresses, and what follows from them and
// a state, in plane strain and plane stress alike.
#pragma once

#include <vector>

#include "common/material/elasticity.hpp"
#include "fine/material/material_law.hpp"

namespace stria::fine {

struct J2Parameters {
    Elasticity elasticity;
    double yield_stress;            // MPa, of the virgin material
    double isotropic = 0.0;         // MPa, H of R = H p
    std::vector<double> kinematic;  // MPa, C of each dX = 2/3 C d(eps_p)

    int substeps = 1;  // of a strain increment at points that flow

    [[nodiscard]] int state_size() const { return state::back_stress + 4 * static_cast<int>(kinematic.size()); }
    /// As in MaterialLaw.
    [[nodiscard]] double elastic_margin(int points, int stride, const double* committed) const;

    /// Of sigma : d eps_p = X : d eps_p + (sigma_y + R) dp hardening stores the first term and R dp; sigma_y dp is
    /// dissipated. With X = 2/3 C eps_p and R = H p both are functions of the state: 3/4 X : X / C and H p^2 / 2.
    [[nodiscard]] double stored_energy(const double* state, int stride) const;
};

}  // namespace stria::fine
