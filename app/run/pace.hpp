// How long a run still takes, by the pace that it has kept since its first increment.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

namespace stria {

/// Cycles may be many more than a crack needs to become as long as it is to be: what ends first ends the run.
class Pace {
public:
    /// `cycles`: of the load history. `until`: how long a crack may become, mm; or nothing.
    Pace(int cycles, std::optional<double> until) : cycles_(cycles), until_(until) {}

    /// Of a state at a moment (LoadStep::moment, cycles) with a longest crack of `a`, mm, so many seconds after the
    /// run began: the seconds that are left. Infinite as long as nothing has been gained on the first state.
    double seconds_left(double moment, double a, double seconds) {
        const State now{moment, a, seconds};
        if (!first_) first_ = now;
        const double passed = seconds - first_->seconds;
        const auto at_pace = [&](double gained, double missing) {
            return gained > 0.0 ? passed * std::max(missing, 0.0) / gained : std::numeric_limits<double>::infinity();
        };
        const double by_cycles = at_pace(moment - first_->moment, cycles_ - moment);
        return until_ ? std::min(by_cycles, at_pace(a - first_->a, *until_ - a)) : by_cycles;
    }

private:
    struct State {
        double moment, a, seconds;
    };
    int cycles_;
    std::optional<double> until_;
    std::optional<State> first_;
};

}  // namespace stria
