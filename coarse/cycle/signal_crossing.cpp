#include "coarse/cycle/signal_crossing.hpp"

#include <algorithm>

namespace stria::coarse {
namespace {

constexpr double rounding = 1e-9;  // of a share
constexpr double beside = 10.0;    // precisions: stations as near to where a signal passes zero tell how it does

std::size_t side(double signal) { return is_closed(signal) ? 1 : 0; }

bool is_within(double share) { return share > rounding && share < 1.0 - rounding; }

/// The share of the way from `inner` to the station `across` at which a signal that was seen at `outer` and `inner`, on
/// one side of zero, comes to zero if it goes straight on; beyond 1, or not a number: it does not.
double straight_on(const ClosureStation& outer, const ClosureStation& inner, const ClosureStation& across,
                   std::size_t k) {
    if (is_closed(outer.signal[k]) != is_closed(inner.signal[k])) return NAN;
    const double slope = (inner.signal[k] - outer.signal[k]) / (inner.target - outer.target);
    return -inner.signal[k] / slope / (across.target - inner.target);
}

/// Likewise, if it goes on at the rate that is expected on its side.
double at_rate(const ClosureStation& from, const ClosureStation& across, std::size_t k,
               const ExpectedCrossing& expected) {
    return -from.signal[k] / expected.rate[side(from.signal[k])] / (across.target - from.target);
}

/// Whether the share of a way at which the rate of cycles before leads to zero is known from its beginning, `from`: it
/// is beside it, and what has been seen of the signal on that side, which leads to `straight`, agrees roughly; where
/// that leads nowhere the signal was expected about there. Rates may be old: after an overload nothing goes as before.
bool is_beside(double share, double straight, const ClosureStation& from, double width, double precision,
               const ExpectedCrossing& expected) {
    constexpr double on_it = 1e-3, roughly = 2.0;  // precisions
    const double off = share * width / precision;
    if (!(off >= 0.0 && off <= 0.5)) return false;
    const double other = std::isfinite(straight) ? straight * width : from.target - expected.target;
    return off <= on_it || std::abs(other) <= roughly * precision;
}

/// Where to try what was expected of a signal, as a share of the way between two stations: there, then towards the
/// station that says otherwise, where the rate leads from there or at least as far as the answer may be off. These two
/// tell, or lead on: stations far away do not, since signals bend. Not a number: all that has been tried.
double as_expected(const std::vector<ClosureStation>& way, std::size_t i, std::size_t k, double precision,
                   const ExpectedCrossing& expected) {
    const ClosureStation &before = way[i], &after = way[i + 1];
    const double start = before.target, end = after.target;
    const double share = (expected.target - start) / (end - start), least = 0.9 * precision / std::abs(end - start);
    const auto is_far = [&](std::size_t other, double from) {
        return std::abs(way[other].target - from) > 2.0 * precision;
    };
    if (std::abs(share) <= rounding && (i == 0 || is_far(i - 1, start))) {
        const double there = at_rate(before, after, k, expected);
        return is_within(there) ? std::max(there, least) : least;
    }
    if (std::abs(1.0 - share) <= rounding && (i + 2 == way.size() || is_far(i + 2, end))) {
        const double there = at_rate(after, before, k, expected);
        return 1.0 - (is_within(there) ? std::max(there, least) : least);
    }
    return is_within(share) ? share : NAN;
}

}  // namespace

double next_in_series(double first, double second, double third) {
    const double before = second - first, last = third - second;
    if (!(before * last > 0.0)) return third;
    return third + last * std::min(last / before, before / last);
}

// Signals are nearly straight on either side of zero, and bend there: faces press with another stiffness than they
// open. So two stations on one side tell where it is, or one and its rate, and where they are near it they know. What
// leads to the station across, whose signal says otherwise, leads nowhere; of two the one nearer to where it leads
// tells more. Where both lead to one place they know it if one of them is beside it: from far away they may agree by
// chance, since signals bend on the way as well. The rate of cycles before knows it from a station beside it: were it
// three times the present one, the answer would still be within the precision. A station at which the signal is zero
// but for rounding is the place itself: elastic faces part in each cycle where they did, and what rounding says of them
// there tells nothing.
Crossing crossing(const std::vector<ClosureStation>& way, std::size_t i, std::size_t k, double precision,
                  const ExpectedCrossing& expected) {
    const ClosureStation &before = way[i], &after = way[i + 1];
    const double width = std::abs(after.target - before.target), near = 0.5 * precision / width;
    const double from_before = i > 0 ? straight_on(way[i - 1], before, after, k) : NAN;
    const double from_after = i + 2 < way.size() ? 1.0 - straight_on(way[i + 2], after, before, k) : NAN;
    if (const double share = at_rate(before, after, k, expected);
        is_beside(share, from_before, before, width, precision, expected))
        return {share, true};
    if (const double share = at_rate(after, before, k, expected);
        is_beside(share, 1.0 - from_after, after, width, precision, expected))
        return {1.0 - share, true};
    if (from_before >= 0.0 && from_before <= near) return {from_before, true};
    if (from_after <= 1.0 && from_after >= 1.0 - near) return {from_after, true};
    if (width <= precision) return {0.5, true};
    const auto leads = [&](double share) { return std::min(share, 1.0 - share) > near; };
    const double middle = 0.5 * (from_before + from_after), away = std::min(middle, 1.0 - middle) * width;
    if (leads(from_before) && leads(from_after) && std::abs(from_after - from_before) <= near &&
        away <= beside * precision)
        return {middle, true};
    constexpr std::size_t enough = 8;  // stations for each signal: whatever leads on has had its chance
    if (way.size() > enough * before.signal.size()) return {0.5, false};
    if (const double share = as_expected(way, i, k, precision, expected); std::isfinite(share)) return {share, false};
    if (leads(from_before) && !(leads(from_after) && 1.0 - from_after < from_before)) return {from_before, false};
    if (leads(from_after)) return {from_after, false};
    const double a = std::abs(before.signal[k]), b = std::abs(after.signal[k]);
    return {std::isfinite(a + b) && a + b > 0.0 ? std::clamp(a / (a + b), 0.1, 0.9) : 0.5, false};
}

std::array<double, 2> rates_beside(const std::vector<ClosureStation>& way, std::size_t i, std::size_t k,
                                   double precision, double target) {
    std::array<double, 2> rates{NAN, NAN};
    const auto look_at = [&](std::size_t first, std::size_t station) {
        const double signal = way[station].signal[k], off = way[station].target - target;
        const bool fits = std::abs(off) >= 0.2 * precision && std::abs(off) <= beside * precision;
        double& rate = rates[side(way[first].signal[k])];
        if (std::isnan(rate) && fits && side(signal) == side(way[first].signal[k])) rate = signal / off;
    };
    for (std::size_t before = i + 1; before-- > 0;) look_at(i, before);
    for (std::size_t after = i + 1; after < way.size(); ++after) look_at(i + 1, after);
    return rates;
}

}  // namespace stria::coarse
