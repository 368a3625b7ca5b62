// Measures a cycle while it passes.
#pragma once

#include <vector>

#include "coarse/cycle/compliance_offset.hpp"
#include "coarse/cycle/increment.hpp"
#include "coarse/cycle/signal_of_cycle.hpp"
#include "common/crack/tip.hpp"

namespace stria::coarse {

/// What a meter has seen of the present cycle, and of what it starts from.
struct CycleMemory {
    struct Tip {
        CycleResult cycle;
        bool has_fallen = false;  // K, in this cycle
        CycleResult rest = {};    // extremes of what a load that lags still adds to the rise of the cycle before
        std::vector<SignalOfCycle> signal;
        MouthPath down, up;
    };
    struct Station {                   // what the next increment, or cycle, starts from
        double x = 0.0, y = 0.0;       // of the tip, mm
        double way = 0.0;              // along its crack, mm
        double unit_K = 0.0, K = 0.0;  // nominal: of the load of [load] at its factor 1, and of all there is
        double K_due = 0.0;            // what is asked of the crack as it has grown there, less K
        double CTOD = 0.0, opening = 0.0, CMOD = 0.0, load_factor = 0.0, force = 0.0;  // force: P of the compliance
        double zone = 0.0, zone_axis = 0.0;  // plastic, mm, of flow while the load stood
        bool rose = false;                   // the half cycle that it ends, or stands at the end of
    };
    int cycle = 0;
    double last_target = 0.0;
    std::vector<Tip> tips;
    std::vector<Station> last;
    std::vector<double> x, y;    // of the tips when the last cycle, or the ramp, ended, mm
    std::vector<double> way;     // likewise, along their cracks
    std::vector<char> rises_on;  // per tip: K rises all through the quarter of a cycle behind the last one
};

/// What the nominal K of each tip rises to under loads that follow the end of an increment, MPa sqrt(mm), before it
/// falls; minus infinity where it does not fall under them. Empty: there are no loads.
[[nodiscard]] std::vector<double> peaks_ahead(const Increment& increment, const std::vector<LoadFactors>& loads);

class CycleMeter {
public:
    CycleMeter() = default;
    /// `looks_ahead`: finish() hears of the peaks behind a cycle (LoadController::looks_ahead), which are no part of
    /// the next one then.
    CycleMeter(const Case& input, const ClosureMeter& closure, const std::vector<Tip>& tips, bool looks_ahead = false);

    /// Every increment, the one that ends a cycle included.
    void add(const Increment& increment);

    /// The cycle that the last increment has ended, one result per tip. `peaks`: what K goes on to rise to before it
    /// falls, one per tip (peaks_ahead); empty: none does.
    std::vector<CycleResult> finish(const std::vector<double>& peaks = {});

    [[nodiscard]] const CycleMemory& memory() const { return now_; }
    void resume(const CycleMemory& memory) { now_ = memory; }

private:
    void begin(int cycle);
    /// What [load] changes by over the increment; zero where it stands, as the crack grows or a dead load comes on.
    [[nodiscard]] double rise_of_load(const Increment& increment) const {
        return increment.step.target.value - now_.last_target;
    }
    /// From there on. Where a displacement is controlled an initial stress and dead loads have moved the boundary.
    [[nodiscard]] double value_reached(const Increment& increment) const {
        const bool is_displacement = increment.step.target.control == Control::Displacement;
        return control_ != Control::Displacement || is_displacement ? increment.step.target.value
                                                                    : increment.machine.displacement;
    }
    /// Under the change of all loads (coarse::rise_of_K()); zero where [load] stands.
    [[nodiscard]] double rise_of_K(const Increment& increment, std::size_t t) const;
    /// Where the increment begins: without load, if it is the first.
    [[nodiscard]] double K_before(const Increment& increment, std::size_t t) const;
    /// K rises in the half cycle that the increment belongs to, or stands at the end of; where K turns elsewhere than
    /// [load], as loads lag or travel, [load] does.
    [[nodiscard]] bool half_cycle_rises(const Increment& increment, std::size_t t) const;
    [[nodiscard]] bool rises_on(std::size_t t) const { return t < now_.rises_on.size() && now_.rises_on[t] != 0; }
    /// Where the crack has grown, the loads at which the K of the first tip is what it is asked to be; else those of
    /// the increment.
    [[nodiscard]] LoadFactors loads_asked(const Increment& increment, bool has_grown) const;
    /// What the loads asked of the longer crack would add to the K of the increment, also while its new faces are
    /// released in parts. `K`: under them.
    [[nodiscard]] double K_due(const Increment& increment, std::size_t t, double K) const;
    /// By a tip along its crack since the cycle before ended, mm.
    [[nodiscard]] double way_gone(const CycleMemory::Station& end, std::size_t t);
    void note_signals(CycleMemory::Tip& tip, const Increment& increment, std::size_t t) const;
    void note_slip(CycleResult& cycle, const Increment& increment, std::size_t t) const;
    void note_zone(CycleResult& cycle, const Increment& increment, std::size_t t) const;
    /// P of the compliance at the mouth: what holds the boundaries that [load] moves, for how far they move is no
    /// force; of a load made of forces its factor.
    [[nodiscard]] double force_on_body(const Increment& increment) const {
        return moves_ ? increment.machine.imposed_force : increment.load_factor;
    }
    void note_mouth(CycleMemory::Tip& tip, const Increment& increment, std::size_t t) const;

    OpeningDefinition definition_ = OpeningDefinition::Contact;
    bool looks_ahead_ = false, peaks_between_ends_ = false;
    Control control_ = Control::Load;
    double K_gradient_ = 0.0;       // LoadSection
    bool moves_ = false;            // [load] does so to a boundary
    std::vector<int> follow_main_;  // load cases whose factor is one of [load]
    std::vector<bool> touches_;     // of each tip, whether the faces of its crack have contact
    ClosureMeter::Signals signals_;
    CycleMemory now_;
};

}  // namespace stria::coarse
