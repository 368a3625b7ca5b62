// J2 plasticity in plane stress with linear isotropic hardening and Prager back stresses: the return map projected onto
// sigma_zz = 0 (Simo and Taylor, IJNME 22 (1986) 649; Simo and Hughes, Computational Inelasticity, section 3.4).
#pragma once

#include "fine/material/j2_law.hpp"

namespace stria::fine {

/// The state is that of J2: sigma_zz stays zero, plastic strains and back stresses keep their zz = -(xx + yy). The zz
/// strain increment is not looked at. Throws NumericalFailure where no plastic multiplier is found.
class J2PlaneStress final : public J2Law {
public:
    /// Linear hardening without recall, and an elasticity in plane stress.
    explicit J2PlaneStress(const J2Parameters& parameters) : J2Law(parameters) {}

private:
    void return_points(const J2Update& update, int points, int stride) const override;
};

}  // namespace stria::fine
