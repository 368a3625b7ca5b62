// Elastic fields about a traction-free crack tip, plane strain or plane stress: the singular ones of modes I and II
// (docs/references.md 2.6).
#pragma once

#include <cmath>
#include <numbers>

#include "common/enrichment/tip_functions.hpp"
#include "common/mandel.hpp"
#include "common/material/elasticity.hpp"

namespace stria {

/// In global axes, per unit of what drives the field.
struct TipField {
    Vec2 displacement;         // mm
    Eigen::Matrix2d gradient;  // row: component
    Mandel stress;             // MPa
};

/// Columns: the axes along and across the tip.
inline Eigen::Matrix2d tip_axes(const Tip& tip) {
    return Eigen::Matrix2d{{tip.direction.x(), -tip.direction.y()}, {tip.direction.y(), tip.direction.x()}};
}

/// A place about a tip, with what the fields of both modes take from its angle.
struct TipPlace {
    TipPlace(const Tip& tip, const Vec2& x, int side)
        : polar(tip_polar(tip, x, side)), s(std::sin(polar.theta / 2.0)), c(std::cos(polar.theta / 2.0)),
          s3(std::sin(1.5 * polar.theta)), c3(std::cos(1.5 * polar.theta)) {}

    TipPolar polar;
    double s, c, s3, c3;
};

/// Fields for K_I = 1 (mode 1) or K_II = 1 (mode 2), per MPa sqrt(mm).
inline TipField williams_field(int mode, const Tip& tip, const TipPlace& place, const Elasticity& elastic) {
    const auto& [polar, s, c, s3, c3] = place;
    const double r = polar.r, kappa = elastic.kolosov(), mu = elastic.shear_modulus();
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
    const Eigen::Matrix2d axes = tip_axes(tip);
    TipField field;
    field.displacement = amplitude * (axes * a);
    field.gradient =
        amplitude / r * (axes * (0.5 * a * polar.radial.transpose() + slope * polar.circumferential.transpose()));
    field.stress = elastic.stiffness() * strain_of(field.gradient);
    return field;
}

inline TipField williams_field(int mode, const Tip& tip, const Vec2& x, int side, const Elasticity& elastic) {
    return williams_field(mode, tip, TipPlace(tip, x, side), elastic);
}

}  // namespace stria
