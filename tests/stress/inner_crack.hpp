// The exact field of a straight crack in an infinite plate.
#pragma once

#include <complex>

#include "tests/support/elastic_scene.hpp"

namespace stria::test {

/// An infinite plate with a crack from -a to a along x: uniform tension from all sides, and shear. Westergaard (1939).
struct InnerCrack {
    Vec2 centre, along;
    double a, tension, shear;

    [[nodiscard]] Vec2 displacement(const Vec2& x) const {
        const Vec2 across(-along.y(), along.x());
        const std::complex<double> z((x - centre).dot(along), (x - centre).dot(across));
        const std::complex<double> root = std::sqrt(z - a) * std::sqrt(z + a);
        const double y = z.imag(), k = steel.kolosov(), mu2 = 2.0 * steel.shear_modulus();
        const std::complex<double> I = tension * root, dI = tension * z / root, II = shear * root,
                                   dII = shear * z / root;
        const double u = 0.5 * (k - 1.0) * I.real() - y * dI.imag() + 0.5 * (k + 1.0) * II.imag() + y * dII.real();
        const double v = 0.5 * (k + 1.0) * I.imag() - y * dI.real() - 0.5 * (k - 1.0) * II.real() - y * dII.imag();
        return (u * along + v * across) / mu2;
    }
};

}  // namespace stria::test
