// Measures a cycle while it passes.
#pragma once

#include <vector>

#include "coarse/cycle/increment.hpp"
#include "common/crack/tip.hpp"

namespace stria::coarse {

/// What a meter has seen of the present cycle, and of what it starts from.
struct CycleMemory {
    struct Path {  // of the load, one way
        std::vector<double> load, mouth;
    };
    struct Tip {
        CycleResult cycle;
        bool has_fallen = false;  // K, in this cycle
        CycleResult rest = {};    // extremes of what a load that lags still adds to the rise of the cycle before
        std::vector<char> changed, was_open;  // per signal
        std::vector<OpeningLoads> signal;
        Path down, up;
    };
    struct Station {                   // what the next increment, or cycle, starts from
        double x = 0.0, y = 0.0;       // of the tip, mm
        double unit_K = 0.0, K = 0.0;  // nominal: of the load of [load] at its factor 1, and of all there is
        double CTOD = 0.0, opening = 0.0, CMOD = 0.0, load_factor = 0.0;
        double forward = 0.0, forward_axis = 0.0;  // of flow while the load stood
    };
    int cycle = 0;
    double last_target = 0.0;
    std::vector<Tip> tips;
    std::vector<Station> last;
    std::vector<double> x, y;  // of the tips when the last cycle, or the ramp, ended, mm
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
    /// `rise`: of the load, over the increment; zero where it stands, as the crack grows.
    void measure(CycleMemory::Tip& tip, const Increment& increment, std::size_t t, double rise) const;
    [[nodiscard]] OpeningLoads of_signal(const CycleMemory::Tip& tip, std::size_t signal) const;

    OpeningDefinition definition_ = OpeningDefinition::Contact;
    bool K_is_asked_ = false, looks_ahead_ = false;
    std::vector<bool> touches_;  // of each tip, whether the faces of its crack have contact
    ClosureMeter::Signals signals_;
    CycleMemory now_;
};

}  // namespace stria::coarse
