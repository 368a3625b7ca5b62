// Eq. (2): the tip enrichment functions of one point, values and gradients together.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "common/crack/tip.hpp"

namespace stria {

/// Polar coordinates of a point in a tip's frame. `side`: the crack side the point lies on (0: away from the crack); it
/// chooses the branch of theta behind the tip, so a face point has theta = +-pi and a kink behind the tip tears
/// nothing.
struct TipPolar {
    double r, theta;
    Vec2 radial, circumferential;  // unit vectors in global axes
};

inline TipPolar tip_polar(const Tip& tip, const Vec2& x, int side) {
    const Vec2 d = x - tip.position;
    const double along = d.dot(tip.direction), across = cross(tip.direction, d);
    double theta = std::atan2(across, along);
    const int upper = side * tip.upper;
    if (upper > 0 && theta < -std::numbers::pi / 2.0) theta += 2.0 * std::numbers::pi;
    if (upper < 0 && theta > std::numbers::pi / 2.0) theta -= 2.0 * std::numbers::pi;
    const double r = d.norm();
    const Vec2 radial = r > 0.0 ? Vec2(d / r) : tip.direction;
    return {r, theta, radial, {-radial.y(), radial.x()}};
}

struct TipFunctions {
    Eigen::Matrix<double, 6, 1> value;
    Eigen::Matrix<double, 6, 2> gradient;  // per row: d psi / dx, d psi / dy
};

/// r^p {sin t/2, cos t/2, sin t/2 sin t, cos t/2 sin t, sin t/2 sin 3t, cos t/2 sin 3t} with p = 1/(n+1).
/// r = 0 has no gradient (it is left zero).
inline TipFunctions tip_functions(const Tip& tip, const Vec2& x, int side, double exponent) {
    const TipPolar polar = tip_polar(tip, x, side);
    const double t = polar.theta;
    const double sh = std::sin(t / 2.0), ch = std::cos(t / 2.0), s1 = std::sin(t), c1 = std::cos(t);
    const double s3 = std::sin(3.0 * t), c3 = std::cos(3.0 * t);
    Eigen::Matrix<double, 6, 1> angular, slope;
    angular << sh, ch, sh * s1, ch * s1, sh * s3, ch * s3;
    slope << ch / 2.0, -sh / 2.0, ch * s1 / 2.0 + sh * c1, -sh * s1 / 2.0 + ch * c1, ch * s3 / 2.0 + 3.0 * sh * c3,
        -sh * s3 / 2.0 + 3.0 * ch * c3;
    TipFunctions result;
    const double scale = std::pow(polar.r, exponent);
    result.value = scale * angular;
    const double rate = polar.r > 0.0 ? scale / polar.r : 0.0;
    result.gradient =
        rate * (exponent * angular * polar.radial.transpose() + slope * polar.circumferential.transpose());
    return result;
}

}  // namespace stria
