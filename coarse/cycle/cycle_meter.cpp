#include "coarse/cycle/cycle_meter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coarse/cycle/compliance_offset.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// K_op: of the last contact that is lost. K_cl: of the first that is made on the way down. `K`: where it changes.
void note_change(OpeningLoads& loads, const OpeningChange& change, double K, bool unloading) {
    if (!change.closes) {
        loads.K_op = K;
        loads.lost = std::isnan(K);
    } else if (unloading && std::isnan(loads.K_cl)) {
        loads.K_cl = K;
    }
}

/// Of the first slip in a half cycle.
void note_slip(double& K_slip, const OpeningChange& change, double K) {
    if (change.closes && std::isnan(K_slip)) K_slip = K;
}

}  // namespace

CycleMeter::CycleMeter(OpeningDefinition definition, const ClosureMeter& closure, std::size_t tips)
    : definition_(definition), signals_(closure.signals()) {
    now_.tips.resize(tips);
}

// A cycle runs from maximum to maximum, and the one that it starts from counts, with the crack as it has grown. But its
// K is no larger than was reached: under control of K the crack grows there at a load that was for a shorter one.
void CycleMeter::begin(int cycle) {
    now_.cycle = cycle;
    for (std::size_t t = 0; t < now_.tips.size(); ++t) {
        Tip& tip = now_.tips[t];
        tip = {};
        tip.changed.assign(signals_.first_slip(), 0);
        tip.was_open.assign(signals_.first_slip(), 0);
        tip.signal.assign(signals_.first_slip(), {});
        tip.cycle.K_slip.assign(signals_.slip, NAN);
        tip.cycle.K_slip_unloading.assign(signals_.slip, NAN);
        if (now_.last.empty()) continue;  // full compression: no ramp
        const CycleMemory::Station& start = now_.last[t];
        tip.cycle.K_max = tip.cycle.K_min = start.K;
        tip.cycle.J_max = start.J;
        tip.cycle.CTOD.include(start.CTOD);
        tip.cycle.opening_behind.include(start.opening);
        tip.cycle.forward = start.forward;
        tip.cycle.forward_axis = start.forward_axis;
        tip.down = {{start.load_factor}, {start.CMOD}};
    }
}

void CycleMeter::add(const Increment& increment) {
    if (now_.tips.empty()) return;
    if (increment.step.cycle != now_.cycle || now_.tips.front().signal.size() != signals_.first_slip())
        begin(increment.step.cycle);
    const bool loading = increment.step.target.value > now_.last_target;
    const bool growing = increment.step.target.value == now_.last_target;
    for (std::size_t t = 0; t < now_.tips.size(); ++t) {
        Tip& tip = now_.tips[t];
        measure(tip, increment, t, !loading && !growing);
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
    const std::vector<CycleMemory::Station> before = std::exchange(now_.last, {});
    for (std::size_t t = 0; t < now_.tips.size(); ++t) {
        const TipResult& tip = increment.tips[t];
        double K = increment.K_at_end(t);
        if (growing && t < before.size()) K = std::min(K, before[t].K);
        now_.last.push_back({K, increment.nominal_K[t], increment.K_beside(t), tip.J, tip.CTOD, tip.opening, tip.CMOD,
                             increment.load_factor, growing ? tip.plastic_zone : 0.0,
                             growing ? tip.plastic_zone_axis : 0.0});
        if (now_.length.size() <= t) now_.length.push_back(tip.a);
    }
}

void CycleMeter::measure(Tip& tip, const Increment& increment, std::size_t t, bool unloading) const {
    CycleResult& cycle = tip.cycle;
    const TipResult& result = increment.tips[t];
    const double K = increment.K_at_end(t);
    for (const OpeningChange& change : increment.opening_changes) {
        if (change.tip != static_cast<int>(t)) continue;
        const auto s = at(change.signal);
        if (s >= signals_.first_slip()) {
            std::vector<double>& K_slip = unloading ? cycle.K_slip_unloading : cycle.K_slip;
            note_slip(K_slip[s - signals_.first_slip()], change, increment.K_at(t, change));
            continue;
        }
        note_change(tip.signal[s], change, increment.K_at(t, change), unloading);
        tip.changed[s] = 1;
    }
    for (std::size_t s = 0; s < tip.was_open.size(); ++s)
        if (increment.signal.empty() || increment.signal[t * signals_.all() + s] <= 0.0) tip.was_open[s] = 1;
    cycle.a = result.a;
    cycle.K_initial = increment.initial_K(t);
    cycle.K_max = std::max(cycle.K_max, K);
    cycle.K_min = std::min(cycle.K_min, K);
    cycle.J_max = std::max(cycle.J_max, result.J);
    cycle.CTOD.include(result.CTOD);
    cycle.opening_behind.include(result.opening);
}

// A crack that never closes is open down to the minimum; of one that never opens there is nothing to say.
OpeningLoads CycleMeter::of_signal(const Tip& tip, std::size_t signal) const {
    const bool open_all_cycle = tip.changed[signal] == 0 && tip.was_open[signal] != 0;
    return open_all_cycle ? OpeningLoads{tip.cycle.K_min, tip.cycle.K_min} : tip.signal[signal];
}

std::vector<CycleResult> CycleMeter::finish() {
    std::vector<CycleResult> results;
    for (std::size_t t = 0; t < now_.tips.size(); ++t) {
        Tip& tip = now_.tips[t];
        CycleResult& cycle = tip.cycle;
        cycle.da = cycle.a - now_.length[t];
        now_.length[t] = cycle.a;
        for (std::size_t s = 0; s < signals_.contact; ++s) cycle.contact.push_back(of_signal(tip, s));
        if (signals_.tension > 0) cycle.tension = of_signal(tip, signals_.contact);
        cycle.offset.K_op = now_.last[t].nominal_K *
                                compliance_offset_opening(tip.down.load, tip.down.mouth, tip.up.load, tip.up.mouth) +
                            now_.last[t].K_beside;
        cycle.opening = definition_ == OpeningDefinition::Contact  ? cycle.contact.front()
                        : definition_ == OpeningDefinition::Offset ? cycle.offset
                                                                   : cycle.tension;
        results.push_back(cycle);
    }
    return results;
}

}  // namespace stria::coarse
