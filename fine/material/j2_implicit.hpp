// J2 plasticity in plane strain and plane stress with any isotropic hardening and back stresses of Armstrong and
// Frederick, CEGB report RD/B/N731 (1966), by backward Euler: one scalar equation for the plastic strain increment.
#pragma once

#include <array>

#include "fine/material/j2_law.hpp"

namespace stria::fine {

/// Elasticity on the two parts of a deviator that return alike: its zz component with what balances it in the plane
/// (the equibiaxial stress), and the shears (xx - yy, xy). In plane strain both are deviators like any other.
struct PlaneElasticity {
    MandelMatrix stiffness;
    double biaxial_rate, shear_rate;  // MPa: dev(C : e) of a deviator e of either part, over e

    explicit PlaneElasticity(const Elasticity& elasticity);
};

/// State as of J2. In plane stress sigma_zz stays zero and the zz strain increment is not looked at. A strain increment
/// may be taken in parts at points that flow; the tangent is the symmetric part of the derivative, which recall and
/// parts make unsymmetric. Throws NumericalFailure where the plastic strain increment is not found.
class J2Implicit final : public J2Law {
public:
    explicit J2Implicit(const J2Parameters& parameters) : J2Law(parameters), elasticity_(parameters.elasticity) {}

private:
    void return_points(const J2Update& update, int points, int stride) const override;

    PlaneElasticity elasticity_;
};

}  // namespace stria::fine
