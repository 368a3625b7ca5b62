// J2 plasticity in plane strain and plane stress with any isotropic hardening and back stresses of Armstrong and
// Frederick, CEGB report RD/B/N731 (1966), or with a threshold, by backward Euler: one scalar equation for the plastic
// strain increment.
#pragma once

#include "fine/material/j2_law.hpp"

namespace stria::fine {

/// Elasticity as deviators see it (plane_deviators.hpp).
struct DeviatoricElasticity {
    MandelMatrix stiffness;
    Eigen::Matrix<double, 3, 4> on_deviators;  // MPa: dev(C : eps) of a strain
    Eigen::Array3d rates;                      // MPa: dev(C : e) of a deviator e, which is diagonal

    explicit DeviatoricElasticity(const Elasticity& elasticity);
};

/// State as of J2. In plane stress sigma_zz stays zero and the zz strain increment is not looked at. A strain increment
/// may be taken in parts at points that flow; the tangent is the symmetric part of the derivative, which recall and
/// parts make unsymmetric. Throws NumericalFailure where the plastic strain increment is not found.
class J2Implicit final : public J2Law {
public:
    explicit J2Implicit(const J2Parameters& parameters) : J2Law(parameters), elasticity_(parameters.elasticity) {}

private:
    void return_points(const J2Update& update, int points, int stride) const override;

    DeviatoricElasticity elasticity_;
};

}  // namespace stria::fine
