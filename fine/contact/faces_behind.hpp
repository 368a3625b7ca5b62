// The faces behind a tip, and who tells of them.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "fine/contact/face_operators.hpp"

namespace stria::fine {

/// The faces of a crack between two distances behind a tip, mm along them.
struct FacesBehind {
    int crack;
    double tip;  // arc length
    double from, to = std::numeric_limits<double>::infinity();

    [[nodiscard]] double distance(double s) const { return std::abs(tip - s); }
    /// Both ends are inside, by rounding: a node often lies in the middle of a crack with two tips, or as many elements
    /// behind a tip as are asked for.
    [[nodiscard]] bool contain(int of_crack, double s) const {
        constexpr double rounding = 1e-9;
        return of_crack == crack && distance(s) >= (1.0 - rounding) * from && distance(s) <= (1.0 + rounding) * to;
    }
};

/// Multipliers that tell of such faces, ascending: those whose middle lies there. On faces shorter than two elements
/// there may be none; then those that act there. Empty: the zone has no such faces.
[[nodiscard]] std::vector<int> multipliers_of(const FaceOperators& operators, const FacesBehind& part);

}  // namespace stria::fine
