#include "coarse/cycle/closure_measurement.hpp"

#include <algorithm>
#include <cmath>

namespace stria::coarse {
namespace {

constexpr double precision_of_loads = 0.002;  // of the largest loads of a half cycle
constexpr std::size_t remembered = 3;         // loads at which a signal passed zero

/// Whether loads press the faces of a tip together, beside an initial stress.
bool presses(const TipResult& nominal, const LoadFactors& loads) {
    return (nominal.K_initial != 0.0 ? K_I_under(nominal, loads) : rise_of_K(nominal, loads)) < 0.0;
}

/// Where signal k is expected to pass zero next, in units of the history; NaN: nobody knows.
double expected_load(const ClosureMemory::Crossings& crossings, std::size_t k) {
    if (crossings.loads.empty()) return NAN;
    const double* last = &crossings.loads[remembered * k];
    return next_in_series(last[2], last[1], last[0]);
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

std::vector<OpeningChange> ClosureMeasurement::changes(const LoadStep& step, const NewtonReport& report, const Way& way,
                                                       const Solve& solve) const {
    const double start = way.from.target.value, end = way.to.target.value;
    constexpr double nearby = 0.2;  // of the increment
    double tried = NAN;             // share of it at the last trial that came to equilibrium
    const auto try_at = [&](double target) {
        const double share = (target - start) / (end - start);
        LoadStep part = step;
        part.target.value = target;
        part.target.cases = way.from.target.cases + share * (way.to.target.cases - way.from.target.cases);
        part.predictor = std::abs(share - tried) < nearby ? Predictor(share - tried, 0, true) : Predictor(share, 0);
        const ClosureMeter::Trial trial = solve(part);
        tried = trial.report.converged ? share : NAN;
        return trial;
    };
    const std::vector<double> now = signal(report);
    return meter_.locate(
        {start, way.from.load_factor, memory_.signal, memory_.nearest},
        {end, way.to.load_factor, now, meter_.nearest(report)},
        {precision_of_loads / way.of_loads * std::abs(end - start), try_at, expected(now, way.unit), memory_.largest});
}

LegOutlook ClosureMeasurement::outlook(const LegEnds& leg, const std::vector<TipResult>& nominal) const {
    LegOutlook outlook{.met = {}, .presses = false, .senses = {.with_load = false, .against_load = false}};
    const LoadFactors changes{leg.to.main - leg.from.main, change(leg.from.cases, leg.to.cases)};
    const std::size_t signals = meter_.signals().all();
    for (std::size_t t = 0; t < nominal.size(); ++t) {
        const double rise = rise_of_K(nominal[t], changes);
        const bool with_load = rise * leg.course >= 0.0;
        (with_load ? outlook.senses.with_load : outlook.senses.against_load) = true;
        for (const LoadFactors& end : {leg.from, leg.to}) outlook.presses = outlook.presses || presses(nominal[t], end);
        if (rise < 0.0) outlook.met.push_back(expected_load(memory_.closed, t * signals));
    }
    return outlook;
}

// Where it came or went as it does now in the cycles before.
std::vector<ExpectedCrossing> ClosureMeasurement::expected(const std::vector<double>& now, double unit) const {
    std::vector<ExpectedCrossing> expected;
    if (memory_.opened.loads.empty()) return expected;
    for (std::size_t k = 0; k < now.size(); ++k) {
        const ClosureMemory::Crossings& crossings = is_closed(now[k]) ? memory_.closed : memory_.opened;
        const double* rate = &crossings.rates[2 * k];
        expected.push_back({.target = unit * expected_load(crossings, k), .rate = {rate[0] / unit, rate[1] / unit}});
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
    for (ClosureMemory::Crossings* crossings : {&memory_.opened, &memory_.closed}) {
        crossings->loads.resize(remembered * now.size(), NAN);
        crossings->rates.resize(2 * now.size(), NAN);
    }
    for (const OpeningChange& change : changes) {
        if (std::isnan(change.load_factor)) continue;  // nobody knows
        const std::size_t k = signals.index(change.tip, change.signal);
        auto& [loads, rates] = change.closes ? memory_.closed : memory_.opened;
        double* last = &loads[remembered * k];
        std::copy_backward(last, last + remembered - 1, last + remembered);
        *last = change.target / unit;
        for (std::size_t side = 0; side < 2; ++side)
            if (std::isfinite(change.rate[side])) rates[2 * k + side] = unit * change.rate[side];
    }
    return now;
}

}  // namespace stria::coarse
