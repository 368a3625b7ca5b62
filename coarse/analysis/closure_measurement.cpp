#include "coarse/analysis/closure_measurement.hpp"

#include <algorithm>
#include <cmath>

namespace stria::coarse {
namespace {

constexpr double precision = 0.002;  // of the largest loads of a half cycle

/// Whether loads press the faces of a tip together, beside an initial stress.
bool presses(const TipResult& nominal, const LoadFactors& loads) {
    return (nominal.K_initial != 0.0 ? K_I_under(nominal, loads) : rise_of_K(nominal, loads)) < 0.0;
}

}  // namespace

bool ClosureMeasurement::has_changed(const LoadStep& step, const NewtonReport& report) const {
    const std::vector<double>& before = memory_.signal;
    const std::vector<double> now = signal(report);
    const auto same_sign = [](double a, double b) { return (a > 0.0) == (b > 0.0); };
    if (step.cycle == 0 || before.size() != now.size()) return false;
    return !std::ranges::equal(before, now, same_sign) ||
           meter_.may_hide_slip({0.0, 0.0, before, memory_.nearest}, {1.0, 1.0, now, meter_.nearest(report)});
}

std::vector<OpeningChange> ClosureMeasurement::changes(const LoadStep& step, const NewtonReport& report,
                                                       const End& from, const End& to, double of_loads, double unit,
                                                       const Solve& solve) const {
    const double start = from.target.value, end = to.target.value;
    constexpr double nearby = 0.2;  // of the increment
    double tried = NAN;             // share of it at the last trial that came to equilibrium
    const auto try_at = [&](double target) {
        const double share = (target - start) / (end - start);
        LoadStep part = step;
        part.target.value = target;
        part.target.cases = from.target.cases + share * (to.target.cases - from.target.cases);
        part.predictor = std::abs(share - tried) < nearby ? Predictor(share - tried, 0, true) : Predictor(share, 0);
        const ClosureMeter::Trial trial = solve(part);
        tried = trial.report.converged ? share : NAN;
        return trial;
    };
    const std::vector<double> now = signal(report);
    return meter_.locate({start, from.load_factor, memory_.signal, memory_.nearest},
                         {end, to.load_factor, now, meter_.nearest(report)},
                         precision / of_loads * std::abs(end - start), try_at, expected(now, unit), memory_.largest);
}

LegOutlook ClosureMeasurement::outlook(const LegEnds& leg, const std::vector<TipResult>& nominal) const {
    LegOutlook outlook{.met = {}, .presses = false, .senses = {.with_load = false, .against_load = false}};
    const LoadFactors changes{leg.to.main - leg.from.main, change(leg.from.cases, leg.to.cases)};
    const std::size_t signals = meter_.signals().all();
    for (std::size_t t = 0; t < nominal.size(); ++t) {
        const double rise = rise_of_K(nominal[t], changes);
        const bool with_load = rise * changes.main >= 0.0;
        (with_load ? outlook.senses.with_load : outlook.senses.against_load) = true;
        for (const LoadFactors& end : {leg.from, leg.to}) outlook.presses = outlook.presses || presses(nominal[t], end);
        if (rise < 0.0 && t * signals < memory_.closed.size()) outlook.met.push_back(memory_.closed[t * signals]);
    }
    return outlook;
}

// Where it last came or went as it does now.
std::vector<ExpectedCrossing> ClosureMeasurement::expected(const std::vector<double>& now, double unit) const {
    std::vector<ExpectedCrossing> expected;
    for (std::size_t k = 0; k < memory_.opened.size(); ++k) {
        const bool closes = is_closed(now[k]);
        const std::vector<double>& rates = closes ? memory_.closing_rates : memory_.opening_rates;
        expected.push_back({.target = unit * (closes ? memory_.closed : memory_.opened)[k],
                            .rate = {rates[2 * k] / unit, rates[2 * k + 1] / unit}});
    }
    return expected;
}

std::vector<double> ClosureMeasurement::commit(const LoadStep& step, const NewtonReport& report,
                                               const std::vector<OpeningChange>& changes, double unit) {
    const ClosureMeter::Signals signals = meter_.signals();
    std::vector<double> now = signal(report);
    for (const OpeningChange& change : changes)  // may have been on the way, and be seen no more
        if (signals.is_slip(at(change.signal))) now[signals.index(change.tip, change.signal)] = 1.0;
    memory_.signal = now;
    memory_.largest.resize(now.size(), 0.0);
    for (std::size_t k = 0; k < now.size(); ++k)
        if (std::isfinite(now[k])) memory_.largest[k] = std::max(memory_.largest[k], std::abs(now[k]));
    memory_.nearest = meter_.nearest(report);
    for (coupling::NearestContact& contact : memory_.nearest)  // from here on it has slid nowhere
        contact.excess = std::min(contact.excess, 0.0);
    if (step.reversal) meter_.forget_slip(memory_.signal);
    for (std::vector<double>* loads : {&memory_.opened, &memory_.closed}) loads->resize(now.size(), NAN);
    for (std::vector<double>* rates : {&memory_.opening_rates, &memory_.closing_rates})
        rates->resize(2 * now.size(), NAN);
    for (const OpeningChange& change : changes) {
        if (std::isnan(change.load_factor)) continue;  // nobody knows
        const std::size_t k = signals.index(change.tip, change.signal);
        (change.closes ? memory_.closed : memory_.opened)[k] = change.target / unit;
        std::vector<double>& rates = change.closes ? memory_.closing_rates : memory_.opening_rates;
        for (std::size_t side = 0; side < 2; ++side)
            if (std::isfinite(change.rate[side])) rates[2 * k + side] = unit * change.rate[side];
    }
    return now;
}

}  // namespace stria::coarse
