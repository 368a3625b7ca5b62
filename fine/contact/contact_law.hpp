// Unilateral contact without friction, per multiplier: p >= 0, g >= 0, p g = 0.
#pragma once

#include <algorithm>

namespace stria::fine {

/// The augmented Lagrangian of eq. (4) with its interface field w eliminated: p = max(0, p - c g), solved as a
/// semismooth Newton step together with the bulk. c is the paper's alpha: it weighs pressures against gaps and changes
/// no solution.
struct UnilateralContact {
    /// Augmented pressure p - c g, MPa: closed where it is positive.
    [[nodiscard]] static double augmented(double pressure, double gap, double c) { return pressure - c * gap; }

    [[nodiscard]] static bool closed(double pressure, double gap, double c) {
        return augmented(pressure, gap, c) > 0.0;
    }

    /// p - max(0, p - c g), MPa: zero exactly where the three conditions hold.
    [[nodiscard]] static double residual(double pressure, double gap, double c) {
        return pressure - std::max(0.0, augmented(pressure, gap, c));
    }
};

}  // namespace stria::fine
