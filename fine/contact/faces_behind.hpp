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
    [[nodiscard]] bool contain(int of_crack, double s) const {
        return of_crack == crack && distance(s) >= from && distance(s) <= to;
    }
};

/// Multipliers that tell of such faces, ascending: those whose middle lies there. On faces shorter than two elements
/// there may be none; then those that act there. Empty: the zone has no such faces.
[[nodiscard]] std::vector<int> multipliers_of(const FaceOperators& operators, const FacesBehind& part);

}  // namespace stria::fine
