#include "coarse/cycle/cycle_meter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "coarse/cycle/compliance_offset.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// K_op: of the last contact that is lost in loading. K_cl: of the first that is made on the way down. `K`: where it
/// changes.
void note_change(OpeningLoads& loads, const OpeningChange& change, double K, bool unloading) {
    if (!change.closes && !unloading) {
        loads.K_op = K;
        loads.lost = std::isnan(K);
    } else if (change.closes && unloading) {
        if (std::isnan(loads.K_cl)) loads.K_cl = K;
        loads.K_op = NAN;
    }
}

/// What is least may be where a cycle starts: load cases may run against the load, and K with them.
void start_from(CycleResult& cycle, const CycleMemory::Station& start) {
    cycle.K_min = std::min(cycle.K_min, start.K);  // NaN: it belongs to the cycle before
    cycle.CTOD.include(start.CTOD, false);
    cycle.opening_behind.include(start.opening, false);
}

/// Where a crack grows at its minimum loading begins with the longer one, whose K that load gives if no K is asked for.
/// `K`: as it grows. Under load cases it may have been less elsewhere in the cycle.
void begin_loading_again(CycleResult& cycle, double K, bool K_is_asked) {
    constexpr CycleResult none;
    constexpr double rounding = 1e-9;
    if (K > cycle.K_min + rounding * std::abs(K)) return;
    if (!K_is_asked) cycle.K_min = none.K_min;
    cycle.CTOD.least = none.CTOD.least;
    cycle.opening_behind.least = none.opening_behind.least;
}

/// Of the cycle before: a load that lags still lifts K in the first quarter of this one.
bool is_rest_of_rise(const CycleMemory::Tip& tip, const LoadStep& step) {
    return !tip.has_fallen && step.moment - (step.cycle - 1) <= 0.25 * (1.0 + 1e-9);
}

/// `loading`: K rises to the increment's end, or the cycle ends there. With load cases it may rise in any part of it.
/// `touches`: else faces that are pressed overlap, and J is none of a crack. As loading begins it would be that of the
/// minimum: the larger, the smaller the increments are.
void take_extremes(CycleResult& cycle, const Increment& increment, std::size_t t, bool loading, bool touches) {
    const TipResult& tip = increment.tips[t];
    const double K = increment.K_at_end(t);
    cycle.a = tip.a;
    cycle.K_initial = increment.nominal[t].K_initial;
    cycle.K_min = std::isnan(K) ? K : std::min(cycle.K_min, K);
    if (std::isnan(K)) cycle.K_max = K;
    if (loading) {
        cycle.K_max = std::max(cycle.K_max, K);                                // NaN stays NaN
        if (touches || K >= 0.0) cycle.J_max = std::fmax(cycle.J_max, tip.J);  // NaN where nobody tells J
    }
    cycle.CTOD.include(tip.CTOD, loading);
    cycle.opening_behind.include(tip.opening, loading);
}

/// Where the cycle before rose no higher than this one does, its rest stands for that of this one, which is to come.
void take_rest(CycleResult& cycle, const CycleResult& rest) {
    constexpr double longer_crack = 1.02;
    if (!(rest.K_max <= longer_crack * cycle.K_max)) return;
    cycle.J_max = std::fmax(cycle.J_max, rest.J_max);
    cycle.CTOD.most = std::max(cycle.CTOD.most, rest.CTOD.most);
    cycle.opening_behind.most = std::max(cycle.opening_behind.most, rest.opening_behind.most);
}

/// Of the first slip in a half cycle.
void note_slip(double& K_slip, const OpeningChange& change, double K) {
    if (change.closes && std::isnan(K_slip)) K_slip = K;
}

/// At the end of an increment. No change tells what comes or goes at that load itself, behind the longer crack; and
/// where contact is lost on the way down the crack is open from the minimum on. `K`: there. `rise`: of the load.
void note_state(CycleMemory::Tip& tip, std::size_t signal, bool is_open, double K, double rise) {
    OpeningLoads& loads = tip.signal[signal];
    const bool changed = tip.changed[signal] != 0;
    if (is_open && changed && (std::isnan(loads.K_op) || rise < 0.0) && !loads.lost) loads.K_op = K;
    if (!is_open && !changed && tip.was_open[signal] != 0 && rise <= 0.0) {
        loads.K_cl = K;
        tip.changed[signal] = 1;
    }
    if (is_open) tip.was_open[signal] = 1;
}

}  // namespace

CycleMeter::CycleMeter(const Case& input, const ClosureMeter& closure, const std::vector<Tip>& tips, bool looks_ahead)
    : definition_(input.closure.definition), K_is_asked_(input.load.control == Control::StressIntensity),
      looks_ahead_(looks_ahead), signals_(closure.signals()) {
    now_.tips.resize(tips.size());
    for (const Tip& tip : tips) touches_.push_back(input.cracks[at(tip.crack)].contact.has_value());
}

// The maximum that it starts from is that of the cycle before.
void CycleMeter::begin(int cycle) {
    now_.cycle = cycle;
    for (std::size_t t = 0; t < now_.tips.size(); ++t) {
        CycleMemory::Tip& tip = now_.tips[t];
        tip = {};
        tip.changed.assign(signals_.first_slip(), 0);
        tip.was_open.assign(signals_.first_slip(), 0);
        tip.signal.assign(signals_.first_slip(), {});
        tip.cycle.K_slip.assign(signals_.slip, NAN);
        tip.cycle.K_slip_unloading.assign(signals_.slip, NAN);
        if (now_.last.empty()) continue;  // full compression: no ramp
        const CycleMemory::Station& start = now_.last[t];
        tip.cycle.forward = start.forward;
        tip.cycle.forward_axis = start.forward_axis;
        start_from(tip.cycle, start);
        tip.down = {{start.load_factor}, {start.CMOD}};
    }
}

void CycleMeter::add(const Increment& increment) {
    if (now_.tips.empty()) return;
    if (increment.step.cycle != now_.cycle || now_.tips.front().signal.size() != signals_.first_slip())
        begin(increment.step.cycle);
    const double rise = increment.step.target.value - now_.last_target;
    const bool loading = rise > 0.0, stands = rise == 0.0;  // as the crack grows, or a dead load comes on
    for (std::size_t t = 0; t < now_.tips.size(); ++t) {
        CycleMemory::Tip& tip = now_.tips[t];
        const bool rises = !stands && t < now_.last.size() && increment.K_at_end(t) > now_.last[t].K;
        measure(tip, increment, t, rise);
        const bool has_grown = tip.cycle.a > 0.0 && increment.tips[t].a > tip.cycle.a;  // within this cycle
        if (has_grown) begin_loading_again(tip.cycle, now_.last[t].K, K_is_asked_);
        if (!stands && !rises) tip.has_fallen = true;
        const bool loading_now = rises || increment.step.ends_cycle;
        const bool of_before = looks_ahead_ && is_rest_of_rise(tip, increment.step);
        take_extremes(tip.cycle, increment, t, loading_now && !of_before, touches_[t]);
        if (of_before) take_extremes(tip.rest, increment, t, rises, touches_[t]);
        CycleMemory::Path& path = loading ? tip.up : tip.down;
        if (loading && path.load.empty() && !tip.down.load.empty())
            path = {{tip.down.load.back()}, {tip.down.mouth.back()}};
        path.load.push_back(increment.load_factor);
        path.mouth.push_back(increment.tips[t].CMOD);
        double& extent = loading ? tip.cycle.forward : tip.cycle.cyclic;
        double& axis = loading ? tip.cycle.forward_axis : tip.cycle.cyclic_axis;
        extent = std::max(extent, increment.tips[t].plastic_zone);
        axis = std::max(axis, increment.tips[t].plastic_zone_axis);
    }
    now_.last_target = increment.step.target.value;
    now_.last.clear();
    for (std::size_t t = 0; t < now_.tips.size(); ++t) {
        const TipResult& tip = increment.tips[t];
        now_.last.push_back({tip.x, tip.y, increment.nominal[t].K_I, increment.K_at_end(t), tip.CTOD, tip.opening,
                             tip.CMOD, increment.load_factor, stands ? tip.plastic_zone : 0.0,
                             stands ? tip.plastic_zone_axis : 0.0});
        if (now_.x.size() > t) continue;
        now_.x.push_back(tip.x);
        now_.y.push_back(tip.y);
    }
}

void CycleMeter::measure(CycleMemory::Tip& tip, const Increment& increment, std::size_t t, double rise) const {
    const bool unloading = rise < 0.0;
    CycleResult& cycle = tip.cycle;
    for (const OpeningChange& change : increment.opening_changes) {
        if (change.tip != static_cast<int>(t)) continue;
        const auto s = at(change.signal);
        if (signals_.is_slip(s)) {
            std::vector<double>& K_slip = unloading ? cycle.K_slip_unloading : cycle.K_slip;
            note_slip(K_slip[s - signals_.first_slip()], change, increment.K_at(t, change));
            continue;
        }
        note_change(tip.signal[s], change, increment.K_at(t, change), unloading);
        tip.changed[s] = 1;
    }
    for (std::size_t s = 0; s < tip.was_open.size(); ++s) {
        const bool is_open = increment.signal.empty() ||
                             increment.signal[signals_.index(static_cast<int>(t), static_cast<int>(s))] <= 0.0;
        note_state(tip, s, is_open, increment.K_at_end(t), rise);
    }
}

// A crack that never closes is open down to the minimum; of one that never opens there is nothing to say.
OpeningLoads CycleMeter::of_signal(const CycleMemory::Tip& tip, std::size_t signal) const {
    const bool open_all_cycle = tip.changed[signal] == 0 && tip.was_open[signal] != 0;
    return open_all_cycle ? OpeningLoads{tip.cycle.K_min, tip.cycle.K_min} : tip.signal[signal];
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

std::vector<CycleResult> CycleMeter::finish(const std::vector<double>& peaks) {
    std::vector<CycleResult> results;
    for (std::size_t t = 0; t < now_.tips.size(); ++t) {
        CycleMemory::Tip& tip = now_.tips[t];
        CycleResult& cycle = tip.cycle;
        if (!peaks.empty()) cycle.K_max = std::max(cycle.K_max, peaks[t]);
        take_rest(cycle, tip.rest);
        // Its own way, and not what `a` grows by: that is half of the crack where it has two tips.
        const CycleMemory::Station& end = now_.last[t];
        cycle.da = std::hypot(end.x - now_.x[t], end.y - now_.y[t]);
        now_.x[t] = end.x;
        now_.y[t] = end.y;
        for (std::size_t s = 0; s < signals_.contact; ++s) cycle.contact.push_back(of_signal(tip, s));
        if (signals_.tension > 0) cycle.tension = of_signal(tip, signals_.contact);
        const std::optional<double> opened =
            compliance_offset_opening(tip.down.load, tip.down.mouth, tip.up.load, tip.up.mouth);
        if (opened) cycle.offset.K_op = end.K + end.unit_K * (*opened - end.load_factor);
        cycle.offset.lost = !opened;
        cycle.opening = definition_ == OpeningDefinition::Contact  ? cycle.contact.front()
                        : definition_ == OpeningDefinition::Offset ? cycle.offset
                                                                   : cycle.tension;
        results.push_back(cycle);
    }
    return results;
}

}  // namespace stria::coarse
