#include "coarse/analysis/growth/growth_law.hpp"

#include <algorithm>
#include <cmath>

namespace stria::coarse {

namespace {

double driving_range(GrowthDriving driving, const CycleResult& cycle) {
    switch (driving) {
    case GrowthDriving::Range:
        return std::max(cycle.K_max, 0.0) - std::max(cycle.K_min, 0.0);
    case GrowthDriving::FullRange:
        return cycle.K_max - cycle.K_min;
    case GrowthDriving::EffectiveRange:
        break;
    }
    return cycle.K_max - cycle.opening.K_op;
}

}  // namespace

double growth_rate(const GrowthSection& growth, const CycleResult& cycle) {
    if (growth.law == GrowthLaw::Prescribed) return growth.increment.value();
    const double range = growth.law == GrowthLaw::Paris ? driving_range(growth.driving, cycle) : cycle.opening_range();
    return range > 0.0 ? growth.C * std::pow(range, growth.m) : 0.0;  // no opening load: it never opens
}

std::vector<double> advances(const GrowthSection& growth, double increment, const std::vector<CycleResult>& last,
                             std::size_t tips) {
    std::vector<double> advance(tips, increment);
    if (growth.law == GrowthLaw::Prescribed) return advance;
    const double fastest = fastest_rate(growth, last);
    for (std::size_t t = 0; t < tips; ++t)
        advance[t] = fastest > 0.0 ? increment * (growth_rate(growth, last[t]) / fastest) : 0.0;
    return advance;
}

double fastest_rate(const GrowthSection& growth, const std::vector<CycleResult>& cycles) {
    double fastest = 0.0;
    for (const CycleResult& cycle : cycles) fastest = std::max(fastest, growth_rate(growth, cycle));
    return fastest;
}

double cycles_passed(double grown, double rate_before, double rate_after) {
    return grown > 0.0 ? 0.5 * grown * (1.0 / rate_before + 1.0 / rate_after) : 0.0;
}

}  // namespace stria::coarse
