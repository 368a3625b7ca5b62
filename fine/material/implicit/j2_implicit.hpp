// J2 plasticity in plane strain and plane stress with any isotropic hardening and back stresses of Armstrong and
// Frederick, CEGB report RD/B/N731 (1966), or with a threshold, by backward Euler, or in parts within an error bound by
// a method of second order that is made of it: one scalar equation for the plastic strain increment.
#pragma once

#include "fine/material/implicit/deviatoric_elasticity.hpp"
#include "fine/material/implicit/return_law.hpp"
#include "fine/material/j2_law.hpp"

namespace stria::fine {

/// State as of J2. In plane stress sigma_zz stays zero and the zz strain increment is not looked at. The tangent is the
/// symmetric part of the derivative, which recall and parts make unsymmetric. Throws NumericalFailure where the plastic
/// strain increment is not found.
class J2Implicit final : public J2Law {
public:
    explicit J2Implicit(const J2Parameters& parameters)
        : J2Law(parameters), elasticity_(parameters.elasticity), law_(parameters, elasticity_.rates) {}

private:
    void return_points(const J2Update& update, int points, int stride) const override;

    DeviatoricElasticity elasticity_;
    ReturnLaw law_;
};

}  // namespace stria::fine
