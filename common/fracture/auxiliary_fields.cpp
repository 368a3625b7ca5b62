#include "common/fracture/auxiliary_fields.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "common/enrichment/tip_functions.hpp"

namespace stria {
namespace {

/// Cosine and sine of half the polar angle of a place in the tip's axes, on its side of the crack (tip_polar()).
struct HalfAngle {
    HalfAngle(double along, double across, double r, int upper) {
        if (along > 0.0) {
            c = std::sqrt(0.5 + 0.5 * along / r);
            s = across / (2.0 * r * c);
            return;
        }
        s = std::copysign(std::sqrt(0.5 - 0.5 * along / r), across);
        c = across / (2.0 * r * s);
        const bool above = !std::signbit(across);
        if (along < 0.0 && (above ? upper < 0 : upper > 0)) c = -c, s = -s;  // a whole turn farther
    }

    double c, s;
};

}  // namespace

AuxiliaryFields::AuxiliaryFields(const Tip& tip, const Elasticity& elastic) : tip_(tip) {
    const Vec2& d = tip.direction;
    const double kappa = elastic.kolosov(), mu = elastic.shear_modulus();
    cos_twice_ = d.x() * d.x() - d.y() * d.y();
    sin_twice_ = 2.0 * d.x() * d.y();
    compliance_ = 0.5 / mu;
    contraction_ = 0.25 * (3.0 - kappa);
    turning_ = 0.5 * (kappa + 1.0) / mu;
}

AuxiliaryField AuxiliaryFields::in_global_axes(double along, double across, double shear, double rotation) const {
    const double mean = 0.5 * (along + across), half = 0.5 * (along - across);
    const double turned = half * cos_twice_ - shear * sin_twice_;
    AuxiliaryField field;
    field.stress_xx = mean + turned;
    field.stress_yy = mean - turned;
    field.stress_xy = half * sin_twice_ + shear * cos_twice_;
    const double all_round = 2.0 * contraction_ * mean;
    field.strain_xx = compliance_ * (field.stress_xx - all_round);
    field.strain_yy = compliance_ * (field.stress_yy - all_round);
    field.shear = 2.0 * compliance_ * field.stress_xy;
    const Vec2& d = tip_.direction;
    field.slope = {field.strain_xx * d.x() + (0.5 * field.shear - rotation) * d.y(),
                   (0.5 * field.shear + rotation) * d.x() + field.strain_yy * d.y()};
    return field;
}

// Of modes I and II phi' = K / (2 sqrt(2 pi z)) and -i times that, of the force phi' = -1 / (4 pi z); the trace of the
// stress is 4 Re phi', the rotation (kappa + 1) / (2 mu) Im phi'.
std::array<AuxiliaryField, 3> AuxiliaryFields::at(const Vec2& x, int side) const {
    const Vec2 &d = tip_.direction, from_tip = x - tip_.position;
    const double along = from_tip.dot(d), across = cross(d, from_tip);
    const double r = from_tip.norm();
    const auto [c, s] = HalfAngle(along, across, r, side * tip_.upper);
    const double c3 = c * (4.0 * c * c - 3.0), s3 = s * (3.0 - 4.0 * s * s);
    const double k = 1.0 / std::sqrt(2.0 * std::numbers::pi * r);
    const double kc = k * c, ks = k * s, force = 1.0 / (std::numbers::pi * r), cos = along / r, sin = across / r;
    const double radial = -force * cos;
    return {in_global_axes(kc * (1.0 - s * s3), kc * (1.0 + s * s3), ks * c * c3, -0.5 * turning_ * ks),
            in_global_axes(-ks * (2.0 + c * c3), ks * c * c3, kc * (1.0 - s * s3), -0.5 * turning_ * kc),
            in_global_axes(radial * cos * cos, radial * sin * sin, radial * cos * sin, 0.25 * turning_ * force * sin)};
}

// Of Kolosov's functions: trace = 4 Re phi', deviator yy - xx + 2i xy = 2 (conj(z) phi'' + psi'), where free faces ask
// for psi' = -z phi'' (I) or -2 phi' - z phi'' (II); the force alone makes radial stress, deviator (1/z + conj(z)/z^2)
// / (2 pi). Along the tip z and conj(z) change by 1.
std::array<Mandel, 3> AuxiliaryFields::stress_slopes(const Vec2& x, int side) const {
    using Complex = std::complex<double>;
    const TipPolar polar = tip_polar(tip_, x, side);
    const Complex z = std::polar(polar.r, polar.theta), mirrored = std::conj(z);
    const Complex first = 0.5 / (std::sqrt(2.0 * std::numbers::pi) * std::polar(std::sqrt(polar.r), 0.5 * polar.theta));
    const Complex second = -0.5 * first / z, third = -1.5 * second / z, by_minus_i(0.0, -1.0);
    const Complex to_global(cos_twice_, -sin_twice_);
    const auto in_global = [&](double trace, const Complex& deviator) -> Mandel {
        const Complex turned = to_global * deviator;
        return {0.5 * (trace - turned.real()), 0.5 * (trace + turned.real()), 0.0, turned.imag() / std::numbers::sqrt2};
    };
    const Complex shearing = by_minus_i * second;
    return {in_global(4.0 * second.real(), 2.0 * (mirrored - z) * third),
            in_global(4.0 * shearing.real(), 2.0 * (by_minus_i * (mirrored - z) * third - 2.0 * shearing)),
            in_global((1.0 / (z * z)).real() / std::numbers::pi, -mirrored / (z * z * z) / std::numbers::pi)};
}

}  // namespace stria
