// What a cycle was, tip by tip: extremes, opening and closing loads, plastic zones.
#pragma once

#include <limits>
#include <vector>

namespace stria::coarse {

/// Nominal stress intensities, MPa sqrt(mm); NaN where there is none: closed, or open, all cycle.
struct OpeningLoads {
    double K_op = std::numeric_limits<double>::quiet_NaN(), K_cl = std::numeric_limits<double>::quiet_NaN();
    bool lost = false;  // it opens, but no equilibrium was found that tells where: K_op is missing
};

/// From maximum to maximum.
struct CycleResult {
    double a = 0.0, da = 0.0;  // mm; grown since the cycle before ended
    double K_max = -1e300, K_min = 1e300;
    double J_max = 0.0, CTOD_max = -1e300, CTOD_min = 1e300;
    double forward = 0.0, cyclic = 0.0, forward_axis = 0.0, cyclic_axis = 0.0;  // plastic zones, mm
    std::vector<OpeningLoads> contact;                                          // per distance of the closure meter
    OpeningLoads tension, offset;
    OpeningLoads opening;  // by the definition asked for
    double dN = 1.0;       // cycles that it stands for

    [[nodiscard]] double CTOD_range() const {
        return CTOD_max >= CTOD_min ? CTOD_max - CTOD_min : std::numeric_limits<double>::quiet_NaN();
    }
};

}  // namespace stria::coarse
