// Laws of da/dN: how fast a tip grows, and what that makes of all tips.
#pragma once

#include <vector>

#include "coarse/cycle/cycle_result.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// da/dN of a tip by the law, mm per cycle; 0 where nothing drives it, NaN where it is not known what does. A
/// prescribed law: the increment.
[[nodiscard]] double growth_rate(const GrowthSection& growth, const CycleResult& cycle);

/// That of a tip whose K leaps to a multiple of what it was, at the same ratios to it. NaN where there was none.
[[nodiscard]] double rate_behind_leap(const GrowthSection& growth, double rate, double leap);

/// One per tip, as `cycles`.
[[nodiscard]] std::vector<double> growth_rates(const GrowthSection& growth, const std::vector<CycleResult>& cycles);

/// Of the tips' rates, mm per cycle, at least one: the number of the tip with the largest.
[[nodiscard]] std::size_t fastest_of(const std::vector<double>& rates);

/// The largest of them, mm per cycle; 0 if there are none, NaN where one is.
[[nodiscard]] double fastest_rate(const std::vector<double>& rates);

/// What each tip advances next, mm: the fastest one by `increment`, the others in proportion. By a prescribed law,
/// and before the first cycle is over (`rates` is empty), all tips advance alike. `rates`: one per tip, mm per cycle.
[[nodiscard]] std::vector<double> advances(const GrowthSection& growth, double increment,
                                           const std::vector<double>& rates, std::size_t tips);

/// Cycles that it took to grow by `grown`, mm, from one state to another with the rates da/dN, mm per cycle, of the
/// fastest tip (trapezoidal rule).
[[nodiscard]] double cycles_passed(double grown, double rate_before, double rate_after);

}  // namespace stria::coarse
