// What a cycle was, tip by tip: extremes, opening and closing loads, plastic zones.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace stria::coarse {

/// Nominal stress intensities, MPa sqrt(mm); NaN where there is none: closed, or open, all cycle.
struct OpeningLoads {
    double K_op = std::numeric_limits<double>::quiet_NaN(), K_cl = std::numeric_limits<double>::quiet_NaN();
    bool lost = false;  // it opens, but no equilibrium was found that tells where: K_op is missing
};

/// Of a number in a cycle: the largest that loading reaches, and the smallest. What is no number leaves them as they
/// are.
struct Extremes {
    double most = -std::numeric_limits<double>::infinity(), least = std::numeric_limits<double>::infinity();

    void include(double value, bool loading) {
        if (!std::isfinite(value)) return;
        if (loading) most = std::max(most, value);
        least = std::min(least, value);
    }
    [[nodiscard]] double range() const {
        return most >= least ? most - least : std::numeric_limits<double>::quiet_NaN();
    }
};

/// From one maximum of [load] to the next. What is largest is what loading reaches, for that is what K_op belongs to
/// and what the crack grows by: the maximum that a cycle starts from belongs to the one before.
struct CycleResult {
    double a = 0.0, da = 0.0;  // mm; grown since the cycle before ended
    // Of all increments so far, infinite before the first; NaN where no ring has told K in one of them.
    double K_max = -std::numeric_limits<double>::infinity(), K_min = std::numeric_limits<double>::infinity();
    double J_max = std::numeric_limits<double>::quiet_NaN();
    Extremes CTOD, opening_behind;  // mm; the second at closure.distance behind the tip
    double forward = 0.0, cyclic = 0.0, forward_axis = 0.0, cyclic_axis = 0.0;  // plastic zones, mm
    std::vector<OpeningLoads> contact;                                          // per distance of the closure meter
    OpeningLoads tension, offset;
    // Likewise, MPa sqrt(mm); NaN where nothing begins to slide; empty: nobody measures.
    std::vector<double> K_slip, K_slip_unloading;
    OpeningLoads opening;    // by the definition asked for
    double dN = 1.0;         // cycles that it stands for
    double K_initial = 0.0;  // of the initial stress alone, which the other K contain; at the end, MPa sqrt(mm)

    /// Of a crack without contact, whose faces overlap below zero where others would touch: they count as closed there,
    /// and K_max - K_op is the range in tension (ASTM E647).
    void close_below_zero() {
        const auto close = [&](OpeningLoads& loads) {
            for (double* K : {&loads.K_op, &loads.K_cl}) *K = std::min(std::max(*K, 0.0), K_max);  // NaN stays
        };
        std::ranges::for_each(contact, close);
        close(offset);
    }

    [[nodiscard]] double CTOD_range() const { return CTOD.range(); }
    [[nodiscard]] double opening_range() const { return opening_behind.range(); }
};

}  // namespace stria::coarse
