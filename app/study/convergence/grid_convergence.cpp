#include "app/study/convergence/grid_convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <stdexcept>

#include "app/study/variants/table.hpp"

namespace stria::study {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Orders that an extrapolation may take: a larger one is a difference that is small by chance, and with a smaller one
/// the limit is farther away than all that was calculated (Oberkampf, Roy, Verification and Validation (2010), 8.6).
constexpr double least_order = 0.5, largest_order = 2.0;
constexpr double first_order = 1.0;

/// Roache's factors of safety.
constexpr double shown = 1.25, assumed = 3.0;

/// Differences of two steps between three sizes, h[0] the smallest, where the error goes with h^p.
double ratio_of_differences(const std::vector<GridValue>& h, double p) {
    const auto power = [&](std::size_t k) { return std::pow(h[k].size / h[0].size, p); };
    return (power(2) - power(1)) / (power(1) - 1.0);
}

/// The order that has this ratio, between `least` and 16; the ratio grows with it.
double order_of(const std::vector<GridValue>& h, double ratio) {
    double below = 1e-6, above = 16.0;
    for (int halving = 0; halving < 60; ++halving) {
        const double p = 0.5 * (below + above);
        (ratio_of_differences(h, p) < ratio ? below : above) = p;
    }
    return 0.5 * (below + above);
}

/// What is left from the smallest size to none, by the last difference.
double rest(const std::vector<GridValue>& h, double p) {
    return (h[0].value - h[1].value) / (std::pow(h[1].size / h[0].size, p) - 1.0);
}

}  // namespace

const char* to_text(Approach approach) {
    switch (approach) {
    case Approach::Same:
        return "same";
    case Approach::Assumed:
        return "assumed";
    case Approach::Monotone:
        return "monotone";
    case Approach::Oscillating:
        return "oscillating";
    case Approach::Away:
        return "away";
    }
    return "";
}

GridConvergence grid_convergence(std::vector<GridValue> grids) {
    std::ranges::sort(grids, {}, &GridValue::size);
    const auto repeated = std::ranges::unique(grids, {}, &GridValue::size);
    grids.erase(repeated.begin(), repeated.end());
    if (grids.size() < 2) throw std::invalid_argument("grid_convergence: two sizes at least");
    const std::vector<GridValue>& h = grids;
    const double finest = h[0].value, small = rounding * std::abs(finest);
    const double last = h[0].value - h[1].value;
    if (std::abs(last) <= small) return {Approach::Same, finest, unknown, finest, 0.0};
    if (h.size() == 2) {
        const double left = rest(h, first_order);
        return {Approach::Assumed, finest, unknown, finest + left, assumed * std::abs(left)};
    }
    const double before = h[1].value - h[2].value;
    if (last * before < 0.0) {
        const double swing = std::max(std::abs(last), std::abs(before));
        return {Approach::Oscillating, finest, unknown, unknown, assumed * swing};
    }
    const double ratio = before / last;
    if (ratio <= ratio_of_differences(h, 1e-6)) return {Approach::Away, finest, unknown, unknown, unknown};
    const double order = order_of(h, ratio);
    const double left = rest(h, std::clamp(order, least_order, largest_order));
    const double safety = order >= least_order && order <= largest_order ? shown : assumed;
    return {Approach::Monotone, finest, order, finest + left, safety * std::abs(left)};
}

}  // namespace stria::study
