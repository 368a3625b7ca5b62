// The auxiliary fields of the interaction integrals at a point, as the energy momentum takes them: those of
// williams.hpp without their displacements. Half angles give them from the place, so no angle and no function of one is
// worked out.
#pragma once

#include <array>

#include "common/crack/tip.hpp"
#include "common/material/elasticity.hpp"

namespace stria {

/// In global axes, per unit of what drives the field.
struct AuxiliaryField {
    double stress_xx, stress_yy, stress_xy;  // MPa
    double strain_xx, strain_yy, shear;      // shear: twice strain_xy
    Vec2 slope;                              // of its displacement along the tip
};

class AuxiliaryFields {
public:
    AuxiliaryFields(const Tip& tip, const Elasticity& elastic);

    /// Of the interactions I, II (K = 1 each, MPa sqrt(mm)) and T (a force of 1 N/mm). `side`: as for tip_polar(). Not
    /// at the tip itself.
    [[nodiscard]] std::array<AuxiliaryField, 3> at(const Vec2& x, int side) const;

    /// Derivatives of their stresses along the tip: xx, yy, 0, sqrt(2) xy, MPa/mm.
    [[nodiscard]] std::array<Mandel, 3> stress_slopes(const Vec2& x, int side) const;

private:
    /// Stresses in the tip's axes and the rotation of the field, radians.
    [[nodiscard]] AuxiliaryField in_global_axes(double along, double across, double shear, double rotation) const;

    Tip tip_;
    double cos_twice_, sin_twice_;  // of the angle from x to the tip's direction
    double compliance_;             // of a shear stress: 1 / (2 mu)
    double contraction_;            // strain = compliance (stress - contraction trace(stress) identity)
    double turning_;                // rotation of what Kolosov's function phi' has as imaginary part
};

}  // namespace stria
