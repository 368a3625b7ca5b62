// Laws of da/dN: how fast a tip grows, and what that makes of all tips.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "coarse/cycle/cycle_result.hpp"
#include "coarse/fracture/fracture_parameters.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// da/dN of a tip by the law, mm per cycle; 0 where nothing drives it, NaN where it is not known what does. A
/// prescribed law: the increment.
[[nodiscard]] double growth_rate(const GrowthSection& growth, const CycleResult& cycle);

/// K of a tip at the extremes of a cycle, both modes.
struct TipAtExtremes {
    TipResult maximum, minimum;
};
/// The factor by which what drives a tip leaps as it turns by an angle, radians (K_just_turned). The load ratio leaps
/// too where the modes of the minimum are not those of the maximum; that K_op keeps its place between them is a guess.
[[nodiscard]] double leap_at_turn(const GrowthSection& growth, const CycleResult& cycle, const TipAtExtremes& tip,
                                  double angle);
/// The rate of a tip for which that leaps so. NaN where nothing is left to drive it.
[[nodiscard]] double rate_behind_leap(const GrowthSection& growth, double rate, double leap);

/// The rate behind a turn by `angle`, of a tip that has stood still so far, by its K at the extremes. 0 where K does
/// not tell it (openings do), and where it is one of rounding.
[[nodiscard]] double rate_just_turned(const GrowthSection& growth, const TipAtExtremes& tip, double angle);

/// One per tip, as `cycles`.
[[nodiscard]] std::vector<double> growth_rates(const GrowthSection& growth, const std::vector<CycleResult>& cycles);

/// Of the tips' rates, mm per cycle, at least one: the number of the tip with the largest.
[[nodiscard]] std::size_t fastest_of(const std::vector<double>& rates);

/// The largest of them, mm per cycle; 0 if there are none, NaN where one is.
[[nodiscard]] double fastest_rate(const std::vector<double>& rates);

/// What each tip advances of what the fastest one does: in proportion to `rates`, one per tip, mm per cycle. By a
/// prescribed law, and before the first cycle is over (`rates` is empty), all tips advance alike.
[[nodiscard]] std::vector<double> shares_of_advance(const GrowthSection& growth, const std::vector<double>& rates,
                                                    std::size_t tips);

/// Cycles that it took to grow by `grown`, mm, from one state to another with the rates da/dN, mm per cycle, of the
/// fastest tip (trapezoidal rule).
[[nodiscard]] double cycles_passed(double grown, double rate_before, double rate_after);

/// A growth of the fastest tip.
struct TipGrowth {
    double grown;                    // mm
    double rate_before, rate_after;  // da/dN, mm per cycle
    double length = 0.0;             // of its crack before, mm; 0: not known
    double lengthened = 0.0;         // by all tips of that, mm
};

/// About what the rule is off by: what these are more than the cycles of a rate that goes with a power of the length of
/// the crack, as K does with its root. Where that is not known, or the rate falls, of a rate whose logarithm is
/// straight over the growth. Never negative. `root`: the power with which the rate goes where K goes with the root of
/// the length; 0: not known. So it begins, and as a crack parts a body K rises by more: a parabola of the logarithms
/// through both ends stands for the power then.
[[nodiscard]] double cycles_in_doubt(const TipGrowth& growth, double root = 0.0);

/// Of the fastest tip: the length of its crack, mm, and da/dN, mm per cycle.
struct RateAtLength {
    double length = 0.0, rate = 0.0;
};

/// The same of a growth from `through[first]` to the next of these, of a rate whose logarithm is a parabola of that of
/// the length: of a body that is nearly parted K rises by more than any power. They ascend, lengths and rates.
[[nodiscard]] double cycles_in_doubt(double grown, const std::array<RateAtLength, 3>& through, std::size_t first);

}  // namespace stria::coarse
