// J2 plasticity in plane strain with linear isotropic hardening and Prager back stresses: returned exactly along a
// straight strain increment, or radially at once, in closed form.
#pragma once

#include "fine/material/j2_law.hpp"

namespace stria::fine {

class J2 final : public J2Law {
public:
    /// Linear hardening without recall.
    explicit J2(const J2Parameters& parameters);

private:
    void return_points(const J2Update& update, int points, int stride) const override;

    double bulk_;       // MPa
    double shear_;      // MPa
    double isotropic_;  // MPa, H
    double kinematic_;  // MPa, sum C
    double uniaxial_;   // MPa, 3 G + H + sum C: overstress per unit of plastic flow
};

}  // namespace stria::fine
