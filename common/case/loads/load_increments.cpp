#include "common/case/loads/load_increments.hpp"

#include <algorithm>
#include <cmath>

namespace stria {

bool lags(const LoadCaseSection& load_case) {
    constexpr double half_cycle = 180.0;  // degrees
    return load_case.factor && std::fmod(load_case.phase, half_cycle) != 0.0;
}

int increments_of_travel(const std::vector<BoundarySection>& boundaries, double part) {
    constexpr double most = 1000.0;  // each has a unit load of its own
    double increments = 0.0;
    for (const BoundarySection& boundary : boundaries) {
        if (!boundary.travelling) continue;
        const TravellingPressure& wheel = *boundary.travelling;
        increments = std::max(increments, std::abs(wheel.to - wheel.from) / (part * wheel.half_width));
    }
    constexpr double rounding = 1e-9;
    return 2 * static_cast<int>(std::ceil(std::min(increments, most) / 2.0 - rounding));
}

// A wheel over a rough crack: the range of K_II is 28 % too small where it goes by 1.3 half widths an increment, 6 % by
// a half, 1 % by a quarter. A cycle of two loads 90 degrees apart encloses 5 % too little as a polygon of 12 corners,
// 1 % as one of 24.
void choose_increments(Case& whole) {
    if (!whole.load.steps.is_auto()) return;
    constexpr double part_of_half_width = 0.25;
    constexpr int along_curve = 24;
    const bool curved = std::ranges::any_of(whole.load_cases, lags);
    const int travelling = increments_of_travel(whole.boundaries, part_of_half_width);
    if (curved || travelling > 0)
        whole.load.steps = std::max({whole.load.first_steps(), travelling, curved ? along_curve : 0});
}

}  // namespace stria
