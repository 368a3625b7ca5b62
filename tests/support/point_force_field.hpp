// The point force that extracts the T stress, from the angle itself.
#pragma once

#include <cmath>
#include <numbers>

#include "common/fracture/williams.hpp"

namespace stria::test {

/// A force of 1 N/mm along the tip's direction, at the tip: sigma_rr = -cos(theta) / (pi r) is the only stress of the
/// plane, so the faces are free of traction (Kfouri, Int. J. Fracture 30 (1986) 301). The displacement is zero at
/// r = 1 mm straight ahead; its jump across the faces is a constant.
inline TipField point_force_field(const Tip& tip, const TipPolar& polar, const Elasticity& elastic) {
    const double r = polar.r, t = polar.theta, kappa = elastic.kolosov(), s = std::sin(t), c = std::cos(t);
    const double shear = 1.0 / (4.0 * std::numbers::pi * elastic.shear_modulus());
    const double spread = 0.5 * (kappa + 1.0) * shear, turn = 0.5 * (kappa - 1.0) * shear;
    const Vec2 u(-spread * std::log(r) - shear * s * s, -turn * t + shear * s * c);
    const Vec2 along_r(-spread, 0.0), along_theta(-2.0 * shear * s * c, -turn + shear * (c * c - s * s));  // times r
    const Eigen::Matrix2d axes = tip_axes(tip);
    TipField field;
    field.displacement = axes * u;
    field.gradient =
        (axes * (along_r * polar.radial.transpose() + along_theta * polar.circumferential.transpose())) / r;
    field.stress = elastic.stiffness() * strain_of(field.gradient);
    return field;
}

}  // namespace stria::test
