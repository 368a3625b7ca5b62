#include "coarse/growth/life_count.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "coarse/growth/growth_law.hpp"

namespace stria::coarse {

void LifeCount::turn(double rate) {
    if (memory_.uncounted == 0.0) memory_.rate_at_turn = rate;
}

double LifeCount::count(const GrownTip& tip, double grown, double rate_before, double rate_after) {
    doubt(grown, tip.lengthening * grown, {tip.length - tip.lengthening * grown, rate_before},
          {tip.length, rate_after});
    return cycles_passed(grown, rate_before, rate_after);
}

// Three lengths tell more than two, of both growths between them.
void LifeCount::doubt(double grown, double lengthened, const RateAtLength& from, const RateAtLength& to) {
    CountedGrowth& last = memory_.last;
    const bool rises = from.length > 0.0 && to.length > from.length && to.rate > from.rate;
    constexpr double rounding = 1e-6;
    const bool goes_on = rises && last.grown > 0.0 && last.to.rate == from.rate &&
                         std::abs(last.to.length - from.length) <= rounding * from.length;
    double by_two = 0.0;
    if (goes_on) {
        const std::array<RateAtLength, 3> through{last.from, last.to, to};
        if (last.doubt > 0.0) memory_.doubt += cycles_in_doubt(last.grown, through, 0) - last.doubt;
        memory_.doubt += cycles_in_doubt(grown, through, 1);
    } else {
        by_two = cycles_in_doubt({grown, from.rate, to.rate, from.length, lengthened}, root_);
        memory_.doubt += by_two;
    }
    last = {rises ? grown : 0.0, from, to, by_two};
}

double LifeCount::passed(const GrownTip& tip, double rate_before, double rate_after) {
    if (tip.grown <= 0.0 && !(tip.ends && memory_.uncounted > 0.0)) return 0.0;
    constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
    if (memory_.uncounted == 0.0 && !std::isnan(rate_after) && tip.is_resolved(tip.behind_turn - tip.grown))
        return count(tip, tip.grown, rate_before, rate_after);
    memory_.uncounted += tip.grown;
    // Of a crack that turns again and again no tip is ever far behind a turn.
    const bool known = !std::isnan(rate_after) && tip.is_resolved(std::max(tip.behind_turn, memory_.uncounted));
    if (!known && !(tip.ends && memory_.rate_at_turn > 0.0)) return 0.0;
    const double grown = std::exchange(memory_.uncounted, 0.0),
                 at_turn = std::exchange(memory_.rate_at_turn, not_known);
    if (!known) return count(tip, grown, at_turn, std::max(at_turn, rate_after));  // K that is not resolved is low
    return count(tip, grown, at_turn > 0.0 ? at_turn : rate_after, rate_after);
}

}  // namespace stria::coarse
