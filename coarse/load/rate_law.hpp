// Laws of da/dN as curves: of a range of K, or of the opening behind a tip.
#pragma once

#include "common/case/case.hpp"

namespace stria::coarse {

/// Below which nothing grows, MPa sqrt(mm); 0: there is none.
[[nodiscard]] double threshold_of(const GrowthSection& growth);

/// da/dN, mm per cycle, of a range of K, MPa sqrt(mm), or of the opening, mm. 0 below the threshold, and of NaN. Not
/// for a prescribed law.
[[nodiscard]] double rate_of_range(const GrowthSection& growth, double range);
/// What makes a tip grow at a rate above zero. Likewise.
[[nodiscard]] double range_of_rate(const GrowthSection& growth, double rate);

/// Of the range of K in da/dN; of a table that of its ends. 0 of a prescribed law.
[[nodiscard]] double exponent_of_K(const GrowthSection& growth);

}  // namespace stria::coarse
