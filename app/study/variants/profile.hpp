// The opening along a crack, and how far two of them are apart.
#pragma once

#include <limits>
#include <vector>

namespace stria::study {

/// A number that a run did not give.
inline constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Opening at stations along a crack at one increment; s increases. Empty where no faces were written.
struct Profile {
    std::vector<double> s;        // mm
    std::vector<double> opening;  // mm
};

/// Over the stretch that has stations; NaN with fewer than two.
double mean_opening(const Profile& profile);

/// L2 norm over s of the difference, over that of the reference; between stations linear, beyond them constant. NaN
/// with fewer than two stations, or where the reference is closed throughout.
double relative_error(const Profile& profile, const Profile& reference);

}  // namespace stria::study
