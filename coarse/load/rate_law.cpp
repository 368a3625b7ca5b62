#include "coarse/load/rate_law.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace stria::coarse {
namespace {

/// Straight lines through the logarithms of points, the first and the last of them beyond the ends. All ascend.
double on_logarithmic_lines(const std::vector<double>& x, const std::vector<double>& y, double at) {
    const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, at);
    const auto k = static_cast<std::size_t>(above - x.begin());
    const double slope = std::log(y[k] / y[k - 1]) / std::log(x[k] / x[k - 1]);
    return y[k - 1] * std::pow(at / x[k - 1], slope);
}

}  // namespace

double threshold_of(const GrowthSection& growth) {
    return growth.law == GrowthLaw::Table ? growth.ranges.front() : growth.threshold.value_or(0.0);
}

double rate_of_range(const GrowthSection& growth, double range) {
    if (!(range > 0.0) || range < threshold_of(growth)) return 0.0;
    if (growth.law == GrowthLaw::Table) return on_logarithmic_lines(growth.ranges, growth.rates, range);
    return growth.C * std::pow(range, growth.m);
}

double range_of_rate(const GrowthSection& growth, double rate) {
    if (growth.law == GrowthLaw::Table) return on_logarithmic_lines(growth.rates, growth.ranges, rate);
    return std::pow(rate / growth.C, 1.0 / growth.m);
}

double exponent_of_K(const GrowthSection& growth) {
    switch (growth.law) {
    case GrowthLaw::Paris:
        return growth.m;
    case GrowthLaw::Table:
        return std::log(growth.rates.back() / growth.rates.front()) /
               std::log(growth.ranges.back() / growth.ranges.front());
    case GrowthLaw::Ctod:
        return 2.0 * growth.m;  // openings go with its square
    default:
        return 0.0;
    }
}

}  // namespace stria::coarse
