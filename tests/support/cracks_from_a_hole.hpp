// Cracks from a round hole in an infinite plate, under tension across them or under pins: K from the integral equation
// of their dislocations, each in a plate whose hole is free of traction (docs/references.md 2.8 and 2.10).
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <functional>
#include <numbers>

namespace stria::test {

/// Stress across the x axis at x, around a hole of radius 1 that is free of traction, of a dislocation that opens along
/// y at xi and its opposite in the middle of the hole, in units of E' b / (4 pi). Muskhelishvili's potentials: those of
/// the dislocation, phi = 1/(z - xi) and psi = phi + xi/(z - xi)^2, what frees the circle of them, and -1/z with what
/// frees it of that.
inline double stress_of_dislocation(double x, double xi) {
    const auto phi = [&](double z) { return 1.0 / (z - xi); };
    const auto slope = [&](double z) { return -1.0 / ((z - xi) * (z - xi)); };
    const auto psi = [&](double z) { return phi(z) - xi * slope(z); };
    const double w = 1.0 / x;  // the mirror image of x
    const double curvature = 2.0 * phi(w) * phi(w) * phi(w), psi_slope = slope(w) - xi * curvature;
    const double freeing = -phi(w) + w * slope(w) + w * w * psi(w) + phi(0.0);
    const double freeing_slope = -w * w * w * curvature - 2.0 * w * w * w * psi(w) - w * w * w * w * psi_slope;
    const double freeing_psi = w * w * (freeing - x * freeing_slope + phi(w) + phi(0.0));
    const double middle = -2.0 * w * (1.0 + w * w);
    return phi(x) + 0.5 * (2.0 * freeing + x * freeing_slope + freeing_psi + middle);
}

/// Kirsch's stress across the x axis around a hole of radius 1, of the tension 1.
inline double stress_of_tension(double x) { return 1.0 + 0.5 / (x * x) + 1.5 / std::pow(x, 4); }

/// Of two pins that press on either half of the hole, up and down, with the cosine to that: the pressure |sin(theta)|.
/// Its even harmonics, each with Michell's functions r^-n and r^(2-n) of cos(n theta).
inline double stress_of_two_pins(double x) {
    constexpr int harmonics = 2000;
    const double r = std::abs(x), squared = r * r;
    double sum = 2.0 / (std::numbers::pi * squared), power = 1.0;  // r^-n
    for (int k = 1; k < harmonics; ++k) {
        const double n = 2.0 * k, pressure = -4.0 / (std::numbers::pi * (n * n - 1.0));
        power /= squared;
        sum += 0.5 * pressure * power * ((n - 2.0) - n / squared);
    }
    return sum;
}

/// K over stress sqrt(pi length), with the length over the radius of the hole; one crack, or two opposite ones.
/// `stress`: across the way of the cracks before there are any.
inline double factor_of_cracks_from_a_hole(double length, int cracks,
                                           const std::function<double(double)>& stress = stress_of_tension) {
    constexpr int n = 80;
    constexpr double pi = std::numbers::pi;
    const auto place = [&](double t) { return 1.0 + 0.5 * length * (1.0 + t); };
    Eigen::MatrixXd A(n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
    for (int k = 1; k <= n; ++k) {
        const double angle = (2 * k - 1) * pi / (4 * n), xi = place(std::cos(2.0 * angle));
        for (int row = 0; row < n - 1; ++row) {
            const double x = place(std::cos((row + 1) * pi / n));
            A(row, k - 1) = stress_of_dislocation(x, xi) + (cracks == 2 ? stress_of_dislocation(-x, xi) : 0.0);
            A(row, k - 1) *= length * pi / n;
        }
        A(n - 1, k - 1) = (k % 2 == 0 ? 1.0 : -1.0) * std::tan(angle);  // the mouth is not singular
    }
    for (int row = 0; row < n - 1; ++row) {
        const double x = place(std::cos((row + 1) * pi / n));
        b[row] = stress(x);
    }
    const Eigen::VectorXd density = A.partialPivLu().solve(b);
    double at_tip = 0.0;
    for (int k = 1; k <= n; ++k)
        at_tip += (k % 2 == 0 ? -1.0 : 1.0) * density[k - 1] / std::tan((2 * k - 1) * pi / (4 * n)) / n;
    return std::numbers::sqrt2 * pi * std::abs(at_tip);
}

}  // namespace stria::test
