// J2 plasticity in plane strain with linear isotropic hardening and Prager back stresses: radial return in closed form.
#pragma once

#include "fine/material/j2_parameters.hpp"

namespace stria::fine {

class J2 final : public MaterialLaw {
public:
    explicit J2(const J2Parameters& parameters);

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
    J2Parameters parameters_;
    double bulk_;       // MPa
    double shear_;      // MPa
    double kinematic_;  // MPa, sum C
    double uniaxial_;   // MPa, 3 G + H + sum C: overstress per unit of plastic flow
};

}  // namespace stria::fine
