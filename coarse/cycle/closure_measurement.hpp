// K_op, K_cl and K_slip by sub-stepping: contact that came, went or began to slide within an increment is looked for
// between its ends.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "coarse/cycle/closure_meter.hpp"
#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/load/load_controller.hpp"

namespace stria::coarse {

/// What is remembered of signals, one number each (ClosureMeter::signal()).
struct ClosureMemory {
    std::vector<double> signal;                     // of the committed state; empty before the first increment
    std::vector<coupling::NearestContact> nearest;  // likewise, ClosureMeter::nearest()
    std::vector<double> largest;                    // magnitude of each signal that was committed
    struct Crossings {
        // Units of the history at which each signal last passed zero, the time before, and before that: three numbers
        // for each. NaN: it did not.
        std::vector<double> loads;
        // What it changed by per unit of the history beside the last, where it was open, then where it was closed: two
        // numbers for each. NaN: nobody knows.
        std::vector<double> rates;
    };
    Crossings opened, closed;
};

class ClosureMeasurement {
public:
    explicit ClosureMeasurement(ClosureMeter meter, ClosureMemory memory = {})
        : meter_(std::move(meter)), memory_(std::move(memory)) {}

    [[nodiscard]] const ClosureMeter& meter() const { return meter_; }

    /// A signal came or went within an increment of a cycle that has converged.
    [[nodiscard]] bool has_changed(const LoadStep& step, const NewtonReport& report) const;

    /// The end of an increment, or its beginning.
    struct End {
        Target target;
        double load_factor;
    };
    /// What an increment is of the load history.
    struct Way {
        End from, to;
        double of_loads;  // that it changes, of those of the present half cycle (LoadController::part_of_loads())
        double unit;      // of the history, as a target
    };
    /// Where its signals changed between what was committed and what has been found at its end. solve(part) finds the
    /// trial equilibrium of a shorter increment, whose predictor is a share of the attempt that was put aside, or goes
    /// on from a trial nearby.
    using Solve = std::function<ClosureMeter::Trial(const LoadStep&)>;
    [[nodiscard]] std::vector<OpeningChange> changes(const LoadStep& step, const NewtonReport& report, const Way& way,
                                                     const Solve& solve) const;

    /// The increment is committed, with `changes` on its way; returns its signals.
    std::vector<double> commit(const LoadStep& step, const NewtonReport& report,
                               const std::vector<OpeningChange>& changes, double unit);

    /// Committed: what the next increment starts from.
    [[nodiscard]] const ClosureMemory& memory() const { return memory_; }
    /// What a half cycle is expected to do. `nominal`: of each tip; faces meet at or beyond the first distance behind
    /// it.
    [[nodiscard]] LegOutlook outlook(const LegEnds& leg, const std::vector<TipResult>& nominal) const;

private:
    [[nodiscard]] std::vector<double> signal(const NewtonReport& report) const {
        return meter_.signal(report, memory_.signal, memory_.largest);
    }
    [[nodiscard]] std::vector<ExpectedCrossing> expected(const std::vector<double>& now, double unit) const;

    ClosureMeter meter_;
    ClosureMemory memory_;
};

}  // namespace stria::coarse
