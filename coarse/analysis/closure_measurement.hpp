// K_op, K_cl and K_slip by sub-stepping: contact that came, went or began to slide within an increment is looked for
// between its ends.
#pragma once

#include <utility>

#include "coarse/cycle/closure_meter.hpp"
#include "coarse/load/load_controller.hpp"

namespace stria::coarse {

class ClosureMeasurement {
public:
    /// `closed`: signals that are committed (ClosureMeter::closed()); empty before the first increment.
    explicit ClosureMeasurement(ClosureMeter meter, std::vector<char> closed = {})
        : meter_(std::move(meter)), closed_(std::move(closed)) {}

    [[nodiscard]] const ClosureMeter& meter() const { return meter_; }

    /// A signal came or went within an increment of a cycle that has converged. `from`: the target reached before it.
    [[nodiscard]] bool has_changed(const LoadStep& step, const NewtonReport& report, double from) const;

    /// Where its signals changed. `extreme`: the larger magnitude of the targets that the present half cycle joins.
    /// solve(part) finds the trial equilibrium of a shorter increment.
    using Solve = std::function<ClosureMeter::Trial(const LoadStep&)>;
    [[nodiscard]] std::vector<OpeningChange> changes(const LoadStep& step, const NewtonReport& report, double from,
                                                     double extreme, const Solve& solve) const;

    /// The increment is committed; returns its signals.
    std::vector<char> commit(const LoadStep& step, const NewtonReport& report, double from);

    /// Committed: what the next increment starts from.
    [[nodiscard]] const std::vector<char>& closed() const { return closed_; }

private:
    [[nodiscard]] std::vector<char> reached(const LoadStep& step, const NewtonReport& report, double from) const;

    ClosureMeter meter_;
    std::vector<char> closed_;
};

}  // namespace stria::coarse
