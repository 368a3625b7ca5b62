#include "coarse/cycle/cycle_meter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "coarse/load/case_histories.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// What is least may be where a cycle starts: load cases may run against the load, and K with them.
void start_from(CycleResult& cycle, const CycleMemory::Station& start) {
    cycle.K_min = std::min(cycle.K_min, start.K);  // NaN: it belongs to the cycle before
    cycle.CTOD.include(start.CTOD, false);
    cycle.opening_behind.include(start.opening, false);
}

/// Where a crack grows at its minimum loading begins with the longer one. `K`: as it grows. Under load cases it may
/// have been less elsewhere in the cycle.
void begin_loading_again(CycleResult& cycle, double K) {
    constexpr CycleResult none;
    constexpr double rounding = 1e-9;
    if (K > cycle.K_min + rounding * std::abs(K)) return;
    cycle.K_min = none.K_min;
    cycle.CTOD.least = none.CTOD.least;
    cycle.opening_behind.least = none.opening_behind.least;
}

/// A crack has, within this cycle: what K a load makes is another one at all tips, at those that stand as well.
bool some_tip_has_grown(const std::vector<CycleMemory::Tip>& tips, const Increment& increment) {
    for (std::size_t t = 0; t < tips.size(); ++t)
        if (tips[t].cycle.a > 0.0 && increment.tips[t].a > tips[t].cycle.a) return true;
    return false;
}

/// Of the cycle before: a load that lags still lifts K in the first quarter of this one. Where it goes on to do so that
/// cycle has not heard of the peak, and the rise is of this one.
bool is_rest_of_rise(const CycleMemory::Tip& tip, const LoadStep& step) {
    return !tip.has_fallen && step.moment - (step.cycle - 1) <= 0.25 * (1.0 + 1e-9);
}

/// `K`: nominal, at the increment's end. `loading`: K rises to there, or the cycle ends there. With load cases it may
/// rise in any part of it. `touches`: else faces that are pressed overlap, and J is none of a crack. As loading begins
/// it would be that of the minimum: the larger, the smaller the increments are. `is_due`: where loading begins the
/// opening is another one (opening_as_asked).
void take_extremes(CycleResult& cycle, const Increment& increment, std::size_t t, double K, bool loading, bool touches,
                   bool is_due = false) {
    const TipResult& tip = increment.tips[t];
    cycle.a = tip.a;
    cycle.K_initial = increment.nominal[t].K_initial;
    cycle.K_min = std::isnan(K) ? K : std::min(cycle.K_min, K);
    if (std::isnan(K)) cycle.K_max = K;
    if (loading) {
        cycle.K_max = std::max(cycle.K_max, K);                                // NaN stays NaN
        if (touches || K >= 0.0) cycle.J_max = std::fmax(cycle.J_max, tip.J);  // NaN where nobody tells J
    }
    cycle.CTOD.include(tip.CTOD, loading);
    if (!is_due) cycle.opening_behind.include(tip.opening, loading);
}

/// Behind a tip where loading begins, mm: on the line from what it was as the crack grew to what it is at the `K` and
/// the `opening` of the next increment. No number where nothing else is asked, or K stands.
double opening_as_asked(const CycleMemory::Station& grown, double K, double opening, bool touches) {
    const double part = grown.K_due != 0.0 ? grown.K_due / (K - grown.K) : NAN;
    const double there = grown.opening + part * (opening - grown.opening);
    return touches ? std::max(there, std::min(grown.opening, 0.0)) : there;
}

/// Where the cycle before rose no higher than this one does, its rest stands for that of this one, which is to come.
void take_rest(CycleMemory::Tip& tip, bool is_to_come) {
    constexpr double longer_crack = 1.02;
    CycleResult& cycle = tip.cycle;
    const CycleResult& rest = tip.rest;
    if (!(rest.K_max <= longer_crack * cycle.K_max)) {
        for (SignalOfCycle& signal : tip.signal)
            if (is_to_come) signal.miss_rest();
        return;
    }
    for (SignalOfCycle& signal : tip.signal) signal.take_rest();
    cycle.J_max = std::fmax(cycle.J_max, rest.J_max);
    cycle.CTOD.most = std::max(cycle.CTOD.most, rest.CTOD.most);
    cycle.opening_behind.most = std::max(cycle.opening_behind.most, rest.opening_behind.most);
}

}  // namespace

CycleMeter::CycleMeter(const Case& input, const ClosureMeter& closure, const std::vector<Tip>& tips, bool looks_ahead)
    : definition_(input.closure.definition), looks_ahead_(looks_ahead),
      peaks_between_ends_(CaseHistories(input).peak_between_ends()), control_(input.load.control),
      K_gradient_(input.load.K_gradient), signals_(closure.signals()) {
    for (const BoundarySection& section : input.boundaries)
        for (const std::optional<double>& moved : section.displacement)
            moves_ = moves_ || (!section.load_case && moved.value_or(0.0) != 0.0);
    now_.tips.resize(tips.size());
    for (const Tip& tip : tips) touches_.push_back(input.cracks[at(tip.crack)].contact.has_value());
    for (std::size_t k = 0; k < input.load_cases.size(); ++k)
        if (input.load_cases[k].factor) follow_main_.push_back(static_cast<int>(k));
}

// The maximum that it starts from is that of the cycle before.
void CycleMeter::begin(int cycle) {
    now_.cycle = cycle;
    for (std::size_t t = 0; t < now_.tips.size(); ++t) {
        CycleMemory::Tip& tip = now_.tips[t];
        std::vector<SignalOfCycle> signal = std::move(tip.signal);
        signal.resize(signals_.first_slip());
        for (SignalOfCycle& one : signal) one.begin_cycle();
        tip = {};
        tip.signal = std::move(signal);
        tip.cycle.K_slip.assign(signals_.slip, NAN);
        tip.cycle.K_slip_unloading.assign(signals_.slip, NAN);
        if (now_.last.empty()) continue;  // full compression: no ramp
        const CycleMemory::Station& start = now_.last[t];
        (start.rose ? tip.cycle.forward : tip.cycle.cyclic) = start.zone;
        (start.rose ? tip.cycle.forward_axis : tip.cycle.cyclic_axis) = start.zone_axis;
        start_from(tip.cycle, start);
    }
}

void CycleMeter::add(const Increment& increment) {
    if (now_.tips.empty()) return;
    if (increment.step.cycle != now_.cycle || now_.tips.front().signal.size() != signals_.first_slip())
        begin(increment.step.cycle);
    const bool stands = rise_of_load(increment) == 0.0;
    const bool has_grown = some_tip_has_grown(now_.tips, increment);
    const LoadFactors loads = loads_asked(increment, has_grown);
    std::vector<double> due;
    for (std::size_t t = 0; t < now_.tips.size(); ++t) {
        CycleMemory::Tip& tip = now_.tips[t];
        const double K = K_I_under(increment.nominal[t], loads);
        const bool rises = !stands && t < now_.last.size() && K > now_.last[t].K;
        note_signals(tip, increment, t);
        note_slip(tip.cycle, increment, t);
        if (has_grown) begin_loading_again(tip.cycle, now_.last[t].K);
        if (!stands && !rises) tip.has_fallen = true;
        const bool loading = rises || increment.step.ends_cycle;
        const bool of_before = looks_ahead_ && !rises_on(t) && is_rest_of_rise(tip, increment.step);
        due.push_back(K_due(increment, t, K));
        if (due[t] == 0.0 && t < now_.last.size())
            tip.cycle.opening_behind.include(opening_as_asked(now_.last[t], K, increment.tips[t].opening, touches_[t]),
                                             false);
        take_extremes(tip.cycle, increment, t, K, loading && !of_before, touches_[t], due[t] != 0.0);
        if (of_before) take_extremes(tip.rest, increment, t, K, rises, touches_[t]);
        // In shear, where K_I is of the mesh and goes its own way, each increment that loads goes farthest.
        const bool shears = !peaks_between_ends_ && !stands && !rises && rise_of_K(increment, t) > 0.0;
        for (SignalOfCycle& signal : tip.signal) {
            if (of_before && K >= tip.rest.K_max) signal.reach_largest_of_rest();
            if (shears || (loading && !of_before && K >= tip.cycle.K_max)) signal.reach_largest();
        }
        note_zone(tip.cycle, increment, t);
        note_mouth(tip, increment, t);
    }
    std::vector<CycleMemory::Station> reached;
    for (std::size_t t = 0; t < now_.tips.size(); ++t) {
        const TipResult& tip = increment.tips[t];
        reached.push_back({tip.x, tip.y, tip.way, increment.nominal[t].K_I, increment.K_at_end(t), due[t], tip.CTOD,
                           tip.opening, tip.CMOD, increment.load_factor, force_on_body(increment),
                           stands ? tip.plastic_zone : 0.0, stands ? tip.plastic_zone_axis : 0.0,
                           half_cycle_rises(increment, t)});
        if (now_.x.size() > t) continue;
        now_.x.push_back(tip.x);
        now_.y.push_back(tip.y);
        now_.way.push_back(tip.way);
    }
    now_.last = std::move(reached);
    now_.last_target = value_reached(increment);
}

// The load stands while the crack grows, and goes to what is asked of the longer one from there on: a cycle has the K
// between which it would go if it were there already. So a life does not depend on where in a cycle its crack grows.
LoadFactors CycleMeter::loads_asked(const Increment& increment, bool has_grown) const {
    LoadFactors loads(increment.load_factor, increment.step.target.cases);
    if (!has_grown || control_ != Control::StressIntensity || now_.last.empty()) return loads;
    const double longer = increment.tips.front().a - now_.tips.front().cycle.a;
    const double share = std::exp(K_gradient_ * longer) * now_.last.front().unit_K / increment.nominal.front().K_I;
    loads.main *= share;
    for (const int k : follow_main_)
        if (k < loads.cases.size()) loads.cases[k] *= share;
    return loads;
}

double CycleMeter::K_due(const Increment& increment, std::size_t t, double K) const {
    const double due = K - increment.K_at_end(t);
    if (due == 0.0 && increment.step.releases && t < now_.last.size()) return now_.last[t].K_due;
    return std::isfinite(due) ? due : 0.0;
}

// Where a displacement is controlled the load may fall as it rises; unless load cases change, it is what rises.
double CycleMeter::rise_of_K(const Increment& increment, std::size_t t) const {
    const double rise = rise_of_load(increment);
    if (rise == 0.0 || t >= now_.last.size()) return rise;
    LoadFactors change(increment.load_factor - now_.last[t].load_factor,
                       coarse::change(increment.cases_before, increment.step.target.cases));
    if (control_ == Control::Displacement && change.cases.isZero(0.0)) change = LoadFactors(rise);
    const double of_K = coarse::rise_of_K(increment.nominal[t], change);
    return of_K != 0.0 ? of_K : rise;
}

double CycleMeter::K_before(const Increment& increment, std::size_t t) const {
    return t < now_.last.size() ? now_.last[t].K : increment.nominal[t].K_initial;
}

bool CycleMeter::half_cycle_rises(const Increment& increment, std::size_t t) const {
    const double rise = peaks_between_ends_ ? rise_of_load(increment) : rise_of_K(increment, t);
    return rise > 0.0 || (rise == 0.0 && t < now_.last.size() && now_.last[t].rose);
}

void CycleMeter::note_signals(CycleMemory::Tip& tip, const Increment& increment, std::size_t t) const {
    const double rise = rise_of_K(increment, t);
    // What is open at the end of a rise that no change tells of was so where it began; on the ramp nobody looks.
    const bool from_start = rise > 0.0 || increment.step.cycle == 0;
    const double K = from_start ? K_before(increment, t) : increment.K_at_end(t);
    for (const OpeningChange& change : increment.opening_changes)
        if (change.tip == static_cast<int>(t) && !signals_.is_slip(at(change.signal)))
            tip.signal[at(change.signal)].note_change(change.closes, increment.K_at(t, change), rise);
    for (std::size_t s = 0; s < tip.signal.size(); ++s) {
        const bool is_open = increment.signal.empty() ||
                             increment.signal[signals_.index(static_cast<int>(t), static_cast<int>(s))] <= 0.0;
        tip.signal[s].note_state(is_open, K, rise);
    }
}

// The first one in a half cycle.
void CycleMeter::note_slip(CycleResult& cycle, const Increment& increment, std::size_t t) const {
    std::vector<double>& K_slip = half_cycle_rises(increment, t) ? cycle.K_slip : cycle.K_slip_unloading;
    for (const OpeningChange& change : increment.opening_changes) {
        const auto s = at(change.signal);
        if (change.tip != static_cast<int>(t) || !signals_.is_slip(s) || !change.closes) continue;
        double& K = K_slip[s - signals_.first_slip()];
        if (std::isnan(K)) K = increment.K_at(t, change);
    }
}

void CycleMeter::note_zone(CycleResult& cycle, const Increment& increment, std::size_t t) const {
    const bool loading = half_cycle_rises(increment, t);
    double& extent = loading ? cycle.forward : cycle.cyclic;
    double& axis = loading ? cycle.forward_axis : cycle.cyclic_axis;
    extent = std::max(extent, increment.tips[t].plastic_zone);
    axis = std::max(axis, increment.tips[t].plastic_zone_axis);
}

// Each way goes on from where the other one ended, with the crack as it has grown there.
void CycleMeter::note_mouth(CycleMemory::Tip& tip, const Increment& increment, std::size_t t) const {
    if (rise_of_load(increment) == 0.0) return;
    MouthPath& path = half_cycle_rises(increment, t) ? tip.up : tip.down;
    if (path.opening.empty() && t < now_.last.size())
        path.add(now_.last[t].load_factor, now_.last[t].force, now_.last[t].CMOD);
    path.add(increment.load_factor, force_on_body(increment), increment.tips[t].CMOD);
}

std::vector<double> peaks_ahead(const Increment& increment, const std::vector<LoadFactors>& loads) {
    if (loads.empty()) return {};
    std::vector<double> peaks(increment.nominal.size(), -std::numeric_limits<double>::infinity());
    for (std::size_t t = 0; t < peaks.size(); ++t)
        for (std::size_t k = 1; k < loads.size(); ++k) {
            const double before = K_I_under(increment.nominal[t], loads[k - 1]);
            if (K_I_under(increment.nominal[t], loads[k]) > before) continue;
            peaks[t] = before;
            break;
        }
    return peaks;
}

// Its own way, and not what `a` grows by: that is half of the crack where it has two tips.
double CycleMeter::way_gone(const CycleMemory::Station& end, std::size_t t) {
    const double x = std::exchange(now_.x[t], end.x), y = std::exchange(now_.y[t], end.y),
                 way = end.way - std::exchange(now_.way[t], end.way);
    return x == end.x && y == end.y ? 0.0 : way;  // where it stands, no rounding of the other tip's way
}

std::vector<CycleResult> CycleMeter::finish(const std::vector<double>& peaks) {
    std::vector<CycleResult> results;
    now_.rises_on.clear();
    for (const double peak : peaks) now_.rises_on.push_back(std::isinf(peak) ? 1 : 0);
    for (std::size_t t = 0; t < now_.tips.size(); ++t) {
        CycleMemory::Tip& tip = now_.tips[t];
        CycleResult& cycle = tip.cycle;
        const CycleMemory::Station& end = now_.last[t];
        if (!peaks.empty()) cycle.K_max = std::max(cycle.K_max, peaks[t]);
        take_rest(tip, !peaks.empty() && peaks[t] > end.K);
        cycle.da = way_gone(end, t);
        for (std::size_t s = 0; s < signals_.contact; ++s) cycle.contact.push_back(tip.signal[s].loads(cycle.K_min));
        if (signals_.tension > 0) cycle.tension = tip.signal[signals_.contact].loads(cycle.K_min);
        const std::optional<double> opened = opened_by_offset(tip.down, tip.up);
        if (opened) cycle.offset.K_op = end.K + end.unit_K * (*opened - end.load_factor);
        cycle.offset.lost = !opened;
        if (!touches_[t]) cycle.close_below_zero();
        cycle.opening = definition_ == OpeningDefinition::Contact  ? cycle.contact.front()
                        : definition_ == OpeningDefinition::Offset ? cycle.offset
                                                                   : cycle.tension;
        results.push_back(cycle);
    }
    return results;
}

}  // namespace stria::coarse
