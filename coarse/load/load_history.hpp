// The extremes that a load goes through: blocks of cycles, one after the other, repeated.
#pragma once

#include <vector>

#include "common/case/case.hpp"

namespace stria::coarse {

/// The way of the load from one extreme to the next. Values are what [load] scales: load factors, displacements, mm,
/// or stress intensities, MPa sqrt(mm).
struct Leg {
    int cycle;  // 0: the ramp to the first maximum
    double from, to;
    bool at_minimum = false, at_maximum = false;  // of the cycle, at its end
    bool ends_cycle = false;
    bool reversal = false;  // the load turns at its end, or ends
    bool leads = false;     // dead loads come on, before all others: the main load stays at zero
};

/// A cycle runs from its maximum to its minimum and on to the maximum of the next one; the last returns to its own.
std::vector<Leg> legs(const LoadSection& load);

[[nodiscard]] int cycle_count(const LoadSection& load);

/// Cycles have different extremes, of the main load or of a load case.
[[nodiscard]] bool varies(const Case& input);
/// Of a load case.
[[nodiscard]] bool load_cases_vary(const Case& input);

/// The cycles that are left once some have passed, at least a tenth of all, lest the last few of a spectrum stand for
/// it; all of them where the sequence repeats.
[[nodiscard]] LoadSection cycles_ahead(const LoadSection& load, int passed);

/// The largest value of the history, not below zero.
[[nodiscard]] double largest_value(const LoadSection& load);

/// The smallest one, not above zero.
[[nodiscard]] double smallest_value(const LoadSection& load);

/// The least maximum up to which cycles make half of a growth, each in proportion to its range above zero to the power
/// `m`; not below zero.
[[nodiscard]] double median_maximum(const LoadSection& load, double m);

}  // namespace stria::coarse
