#include "coarse/analysis/K_at_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coarse/growth/crack_advance.hpp"
#include "coarse/growth/modes_of_tip.hpp"

namespace stria::coarse {
namespace {

bool is_of_one_load(const CrackedBody& body, const ReachedExtremes& reached) {
    return reached.maximum.cases.size() == 0 && !body.scene().initial_stress().any();
}

/// Where a load has gone at its maximum the one of the minimum is left. The load at a controlled displacement of zero
/// is found, and has gone but for rounding.
double sign_of_load(const ReachedExtremes& reached) {
    constexpr double rounding = 1e-9;
    const bool is_loaded = std::abs(reached.maximum.main) > rounding * std::abs(reached.minimum.main);
    const double factor = is_loaded ? reached.maximum.main : reached.minimum.main;
    return factor < 0.0 ? -1.0 : 1.0;
}

}  // namespace

std::vector<TipResult> K_at_maximum(const CrackedBody& body, const ReachedExtremes& reached) {
    const bool one_load = is_of_one_load(body, reached);
    return nominal_under(one_load ? sign_of_load(reached) : reached.maximum, body.nominal());
}

std::vector<TipResult> K_that_turns(const CrackedBody& body, const ReachedExtremes& reached) {
    std::vector<TipResult> nominal = K_at_maximum(body, reached);
    if (reached.tips.empty()) return nominal;
    std::vector<double> largest = sizes_of(nominal_under(reached.maximum, body.nominal()));
    const std::vector<double> at_minimum = sizes_of(nominal_under(reached.minimum, body.nominal()));
    for (std::size_t t = 0; t < largest.size(); ++t) largest[t] = std::max(largest[t], at_minimum[t]);
    return directing(std::move(nominal), reached.tips, largest);
}

std::vector<TipResult> K_at_minimum(const CrackedBody& body, const ReachedExtremes& reached) {
    if (is_of_one_load(body, reached)) return std::vector<TipResult>(body.nominal().size());
    return nominal_under(reached.minimum, body.nominal());
}

}  // namespace stria::coarse
