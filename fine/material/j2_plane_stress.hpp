// J2 plasticity in plane stress with linear isotropic hardening and Prager back stresses: the return map projected onto
// sigma_zz = 0 (Simo and Taylor, IJNME 22 (1986) 649; Simo and Hughes, Computational Inelasticity, section 3.4).
#pragma once

#include "fine/material/j2_parameters.hpp"

namespace stria::fine {

/// The state is that of J2: sigma_zz stays zero, plastic strains and back stresses keep their zz = -(xx + yy). The zz
/// strain increment is not looked at. Throws NumericalFailure where no plastic multiplier is found.
class J2PlaneStress final : public MaterialLaw {
public:
    explicit J2PlaneStress(const J2Parameters& parameters) : parameters_(parameters) {}

    [[nodiscard]] int state_size() const override { return parameters_.state_size(); }
    void update(int points, int stride, const double* strain_increment, const double* committed, double* trial,
                double* tangent, unsigned char* yielding) const override;
    [[nodiscard]] double elastic_margin(int points, int stride, const double* committed) const override {
        return parameters_.elastic_margin(points, stride, committed);
    }
    [[nodiscard]] double stored_energy(const double* state, int stride) const override {
        return parameters_.stored_energy(state, stride);
    }
    [[nodiscard]] MandelMatrix elastic() const override { return parameters_.elasticity.stiffness(); }

private:
    J2Parameters parameters_;  // of an elasticity in plane stress
};

}  // namespace stria::fine
