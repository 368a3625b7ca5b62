// The singular elastic fields of a traction-free crack tip, modes I and II, plane strain or plane stress
// (REFERENCES 2.6).
#pragma once

#include <cmath>
#include <numbers>

#include "common/fem/tip_functions.hpp"
#include "common/mandel.hpp"
#include "common/material/elasticity.hpp"

namespace stria {

/// Fields for K_I = 1 (mode 1) or K_II = 1 (mode 2), in global axes.
struct WilliamsField {
    Vec2 displacement;         // mm per unit K
    Eigen::Matrix2d gradient;  // row: component
    Mandel stress;             // MPa per unit K
};

inline WilliamsField williams_field(int mode, const Tip& tip, const Vec2& x, int side, const Elasticity& elastic) {
    const TipPolar polar = tip_polar(tip, x, side);
    const double r = polar.r, t = polar.theta, kappa = elastic.kolosov(), mu = elastic.shear_modulus();
    const double s = std::sin(t / 2.0), c = std::cos(t / 2.0), s3 = std::sin(1.5 * t), c3 = std::cos(1.5 * t);
    const double amplitude = std::sqrt(r / (2.0 * std::numbers::pi)) / (2.0 * mu);
    // u = amplitude * a(theta) in the tip's axes; a and da/dtheta, with cos t etc. expanded in half angles.
    Vec2 a, slope;
    if (mode == 1) {
        a = {(kappa - 0.5) * c - 0.5 * c3, (kappa + 0.5) * s - 0.5 * s3};
        slope = {-0.5 * (kappa - 0.5) * s + 0.75 * s3, 0.5 * (kappa + 0.5) * c - 0.75 * c3};
    } else {
        a = {(kappa + 1.5) * s + 0.5 * s3, -(kappa - 1.5) * c - 0.5 * c3};
        slope = {0.5 * (kappa + 1.5) * c + 0.75 * c3, 0.5 * (kappa - 1.5) * s + 0.75 * s3};
    }
    const Eigen::Matrix2d axes{{tip.direction.x(), -tip.direction.y()}, {tip.direction.y(), tip.direction.x()}};
    WilliamsField field;
    field.displacement = amplitude * (axes * a);
    field.gradient =
        amplitude / r * (axes * (0.5 * a * polar.radial.transpose() + slope * polar.circumferential.transpose()));
    field.stress = elastic.stiffness() * strain_of(field.gradient);
    return field;
}

}  // namespace stria
