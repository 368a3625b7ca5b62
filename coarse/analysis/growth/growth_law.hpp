// Laws of da/dN: how fast a tip grows, and what that makes of all tips.
#pragma once

#include <vector>

#include "coarse/cycle/cycle_result.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// da/dN of a tip by the law, mm per cycle; 0 where nothing drives it. A prescribed law: the increment.
[[nodiscard]] double growth_rate(const GrowthSection& growth, const CycleResult& cycle);

/// The largest growth_rate() of all tips, mm per cycle. `cycles`: one per tip.
[[nodiscard]] double fastest_rate(const GrowthSection& growth, const std::vector<CycleResult>& cycles);

/// What each tip advances next, mm: the fastest one by `increment`, the others in proportion. By a prescribed law,
/// and before the first cycle is over (`last` is empty), all tips advance alike. `last`: one per tip.
[[nodiscard]] std::vector<double> advances(const GrowthSection& growth, double increment,
                                           const std::vector<CycleResult>& last, std::size_t tips);

/// Cycles that it took to grow by `grown`, mm, from one state to another with the rates da/dN, mm per cycle, of the
/// fastest tip (trapezoidal rule).
[[nodiscard]] double cycles_passed(double grown, double rate_before, double rate_after);

}  // namespace stria::coarse
