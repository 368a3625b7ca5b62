#include "coarse/growth/growth_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coarse/growth/crack_advance.hpp"
#include "coarse/load/rate_law.hpp"
#include "common/case/case_questions.hpp"

namespace stria::coarse {

namespace {

/// Walker's: K_max (1 - R)^w, the range at R = 0 that drives a tip as much. What lies in compression does not count.
double range_in_tension(double K_max, double K_min, double w) {
    const double most = std::max(K_max, 0.0), range = most - std::max(K_min, 0.0);
    return std::pow(most, 1.0 - w) * std::pow(range, w);
}

double driving_range(const GrowthSection& growth, double K_max, double K_min, double K_op) {
    switch (growth.driving) {
    case GrowthDriving::Range:
        return range_in_tension(K_max, K_min, growth.walker);
    case GrowthDriving::FullRange:
        return K_max - K_min;
    case GrowthDriving::EffectiveRange:
        break;
    }
    return K_max - K_op;
}

/// What drives the tip does not change but for rounding. Under a constant K_I shear may open it all the same.
bool stands(const GrowthSection& growth, const CycleResult& cycle) {
    const bool by_opening = growth.law == GrowthLaw::Ctod;
    const double most = by_opening ? cycle.opening_behind.most : cycle.K_max;
    const double least = by_opening ? cycle.opening_behind.least : cycle.K_min;
    const double range = by_opening ? cycle.opening_range() : most - least;
    return range <= rounding_of_K * std::max(std::abs(most), std::abs(least));
}

double driving_range(const GrowthSection& growth, const CycleResult& cycle) {
    return driving_range(growth, cycle.K_max, cycle.K_min, cycle.opening.K_op);
}

/// What drives the tip has not been told.
bool is_unread(const GrowthSection& growth, const CycleResult& cycle) {
    if (growth.law == GrowthLaw::Ctod) return std::isnan(cycle.opening_range());
    return std::isnan(cycle.K_max) || (grows_by_opening_loads(growth) && cycle.opening.lost);
}

/// Of a growth between two lengths, of a rate whose logarithm is a parabola of that of the length: with the mean slope
/// `steep`, and half of its second derivative.
double cycles_by_parabola(double grown, const RateAtLength& from, const RateAtLength& to, double steep, double bend) {
    const auto per_mm = [&](double way) {
        const double length = std::lerp(from.length, to.length, way), behind = std::log(length / from.length),
                     ahead = std::log(length / to.length);
        return std::exp(-(steep + bend * ahead) * behind) / from.rate;
    };
    constexpr int panels = 128;  // of Simpson's rule
    double sum = per_mm(0.0) + per_mm(1.0);
    for (int k = 1; k < panels; ++k) sum += (k % 2 == 1 ? 4.0 : 2.0) * per_mm(static_cast<double>(k) / panels);
    return grown * sum / (3.0 * panels);
}

}  // namespace

double growth_rate(const GrowthSection& growth, const CycleResult& cycle) {
    if (is_prescribed(growth)) return growth.increment.value();
    if (stands(growth, cycle)) return 0.0;
    if (is_unread(growth, cycle)) return std::numeric_limits<double>::quiet_NaN();
    return rate_of_range(growth, growth.law == GrowthLaw::Ctod ? cycle.opening_range() : driving_range(growth, cycle));
}

double leap_at_turn(const GrowthSection& growth, const CycleResult& cycle, const TipAtExtremes& tip, double angle) {
    const double open = (cycle.opening.K_op - cycle.K_min) / (cycle.K_max - cycle.K_min);
    const auto drive = [&](double K_max, double K_min) {
        return driving_range(growth, K_max, K_min, std::lerp(K_min, K_max, open));
    };
    return drive(K_just_turned(tip.maximum, angle), K_just_turned(tip.minimum, angle)) /
           drive(tip.maximum.K_I, tip.minimum.K_I);
}

double rate_behind_leap(const GrowthSection& growth, double rate, double leap) {
    if (!(leap > 0.0) || std::isinf(leap)) return std::numeric_limits<double>::quiet_NaN();
    const double order = growth.law == GrowthLaw::Ctod ? 2.0 : 1.0;  // of the opening in K
    return rate > 0.0 ? rate_of_range(growth, range_of_rate(growth, rate) * std::pow(leap, order)) : 0.0;
}

double rate_just_turned(const GrowthSection& growth, const TipAtExtremes& tip, double angle) {
    constexpr double an_atom_in_a_million_cycles = 3e-13;  // mm
    if (is_prescribed(growth) || grows_by_openings(growth)) return 0.0;
    const double at_max = K_just_turned(tip.maximum, angle), at_min = K_just_turned(tip.minimum, angle);
    const double most = std::max(at_max, at_min), least = std::min(at_max, at_min);
    const double rate = rate_of_range(growth, driving_range(growth, most, least, least));
    return rate > an_atom_in_a_million_cycles ? rate : 0.0;
}

std::vector<double> growth_rates(const GrowthSection& growth, const std::vector<CycleResult>& cycles) {
    std::vector<double> rates;
    for (const CycleResult& cycle : cycles) rates.push_back(growth_rate(growth, cycle));
    return rates;
}

std::size_t fastest_of(const std::vector<double>& rates) {
    return static_cast<std::size_t>(std::ranges::max_element(rates) - rates.begin());
}

double fastest_rate(const std::vector<double>& rates) {
    double fastest = 0.0;
    for (const double rate : rates) fastest = std::isnan(rate) || rate > fastest ? rate : fastest;
    return fastest;
}

std::vector<double> shares_of_advance(const GrowthSection& growth, const std::vector<double>& rates, std::size_t tips) {
    std::vector<double> shares(tips, 1.0);
    if (is_prescribed(growth) || rates.empty()) return shares;
    const double fastest = fastest_rate(rates);
    for (std::size_t t = 0; t < tips; ++t) shares[t] = fastest > 0.0 ? rates[t] / fastest : 0.0;
    return shares;
}

double cycles_passed(double grown, double rate_before, double rate_after) {
    return grown > 0.0 ? 0.5 * grown * (1.0 / rate_before + 1.0 / rate_after) : 0.0;
}

double cycles_in_doubt(const TipGrowth& growth, double root) {
    const auto [grown, rate_before, rate_after, length, lengthened] = growth;
    if (!(grown > 0.0)) return 0.0;
    const double x = std::log(rate_after / rate_before) / 2.0;
    constexpr double small = 1e-3;  // there rounding would be all of the difference
    const double share = std::abs(x) < small ? x * x / 3.0 : 1.0 - std::tanh(x) / x;
    const double passed = cycles_passed(grown, rate_before, rate_after), of_exponential = share * passed;
    if (!(rate_after > rate_before && length > 0.0 && lengthened > 0.0)) return of_exponential;
    // A power of the length changes more at first than the exponential between the same ends: its cycles are fewer.
    const double stretch = std::log1p(lengthened / length), steep = 2.0 * x / stretch;
    const double bend = root > 0.0 ? (steep - root) / stretch : 0.0;
    const double of_power =
        cycles_by_parabola(grown, {length, rate_before}, {length + lengthened, rate_after}, steep, bend);
    return std::max(of_exponential, passed - of_power);
}

double cycles_in_doubt(double grown, const std::array<RateAtLength, 3>& through, std::size_t first) {
    const RateAtLength &from = through[first], &to = through[first + 1];
    const auto slope = [&](std::size_t k) {
        return std::log(through[k + 1].rate / through[k].rate) / std::log(through[k + 1].length / through[k].length);
    };
    const double bend = (slope(1) - slope(0)) / std::log(through[2].length / through[0].length), steep = slope(first);
    return std::max(0.0, cycles_passed(grown, from.rate, to.rate) - cycles_by_parabola(grown, from, to, steep, bend));
}

}  // namespace stria::coarse
