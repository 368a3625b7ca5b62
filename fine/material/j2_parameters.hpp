// Parameters of J2 plasticity with linear isotropic hardening and Prager back stresses, and what follows from them and
// a state, in plane strain and plane stress alike.
#pragma once

#include <vector>

#include "common/material/elasticity.hpp"
#include "fine/material/hardening_curve.hpp"
#include "fine/material/material_law.hpp"

namespace stria::fine {

/// The return leaves a point on the yield surface up to rounding, and an increment of nothing must not make it flow: a
/// point flows where its overstress exceeds this fraction of the yield stress, far above rounding and below any
/// tolerance.
inline constexpr double overstress_tolerance = 1e-10;

/// C(p), MPa, of a number or of a pack of points.
template <class P> [[nodiscard]] P modulus(const KinematicHardening& term, const P& p) {
    if (!term.C_start) return 0.0 * p + term.C;
    return term.C + (*term.C_start - term.C) * exp(-term.C_rate * p);
}

/// dC/dp over C.
template <class P> [[nodiscard]] P growth_of_modulus(const KinematicHardening& term, const P& p) {
    if (!term.C_start) return 0.0 * p;
    return term.C_rate * (term.C / modulus(term, p) - 1.0);
}

struct J2Parameters {
    Elasticity elasticity;
    double yield_stress;                        // MPa, of the virgin material
    HardeningCurve isotropic;                   // R(p)
    std::vector<KinematicHardening> kinematic;  // each dX = 2/3 C d(eps_p) - gamma X dp

    int substeps = 1;  // how finely strain increments are taken at points that flow; 1: at once, by backward Euler

    /// What the stress may be off at the end of an increment in parts, over the yield stress.
    [[nodiscard]] double error_of_parts() const { return 4e-3 / substeps; }

    /// Sum of C, MPa.
    [[nodiscard]] double prager_modulus() const;
    /// Whether hardening is linear in the plastic strain; whether a back stress forgets at its limit alone.
    [[nodiscard]] bool is_linear() const;
    [[nodiscard]] bool has_thresholds() const;

    [[nodiscard]] int state_size() const { return state::back_stress + 4 * static_cast<int>(kinematic.size()); }
    /// As in MaterialLaw.
    [[nodiscard]] double elastic_margin(int points, int stride, const double* states) const;

    /// Of sigma : d eps_p = X : d eps_p + (sigma_y + R) dp hardening stores R dp and, of the first term, what changes
    /// 3/4 X : X / C, one of a kind for every back stress; both are functions of the state. What recall takes of it,
    /// 3/2 gamma / C X : X dp, is dissipated as sigma_y dp is (J.-L. Chaboche, Int. J. Plasticity 5 (1989) 247).
    [[nodiscard]] double stored_energy(const double* state, int stride) const;
};

}  // namespace stria::fine
