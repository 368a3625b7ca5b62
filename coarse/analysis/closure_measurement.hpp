// K_op, K_cl and K_slip by sub-stepping: contact that came, went or began to slide within an increment is looked for
// between its ends.
#pragma once

#include <utility>

#include "coarse/cycle/closure_meter.hpp"
#include "coarse/load/load_controller.hpp"

namespace stria::coarse {

class ClosureMeasurement {
public:
    /// `signal`: that of the committed state (ClosureMeter::signal()); empty before the first increment.
    explicit ClosureMeasurement(ClosureMeter meter, std::vector<double> signal = {})
        : meter_(std::move(meter)), signal_(std::move(signal)) {}

    [[nodiscard]] const ClosureMeter& meter() const { return meter_; }

    /// A signal came or went within an increment of a cycle that has converged.
    [[nodiscard]] bool has_changed(const LoadStep& step, const NewtonReport& report) const;

    /// The end of an increment, or its beginning.
    struct End {
        Target target;
        double load_factor;
    };
    /// Where its signals changed between what was committed and what has been found at its end. `extreme`: the larger
    /// magnitude of the targets that the present half cycle joins. solve(part) finds the trial equilibrium of a shorter
    /// increment, whose predictor is a share of the attempt that was put aside.
    using Solve = std::function<ClosureMeter::Trial(const LoadStep&)>;
    [[nodiscard]] std::vector<OpeningChange> changes(const LoadStep& step, const NewtonReport& report, const End& from,
                                                     const End& to, double extreme, const Solve& solve) const;

    /// The increment is committed; returns its signals.
    std::vector<double> commit(const LoadStep& step, const NewtonReport& report);

    /// Committed: what the next increment starts from.
    [[nodiscard]] const std::vector<double>& signal() const { return signal_; }

private:
    ClosureMeter meter_;
    std::vector<double> signal_;
};

}  // namespace stria::coarse
