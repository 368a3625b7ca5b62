#include "coarse/equilibrium/newton.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "coarse/equilibrium/line_search.hpp"
#include "common/error.hpp"

namespace stria::coarse {

std::string NewtonReport::table() const {
    std::string text =
        "   it   residual    boundary    interior     contact      target  correction  yielding  closed  changes\n";
    for (std::size_t i = 0; i < iterations.size(); ++i) {
        const auto& [r, correction] = iterations[i];
        text += fmt::format("{:5} {:10.3e} {:11.3e} {:11.3e} {:11.3e} {:11.3e} {:11.3e} {:9} {:7} {:8}\n", i,
                            r.largest() / r.scale, r.boundary, r.interior, r.contact, r.target, correction,
                            r.yielding_points, r.closed, r.status_changes);
    }
    return text;
}

namespace {

/// Newton's method leads nowhere from where the predictor said: after some iterations it is as far off as at first, or
/// as far as it might be from nothing.
bool is_misled(const NewtonReport& report) {
    constexpr std::size_t enough = 4;
    if (report.iterations.size() != enough) return false;
    const Residual &first = report.iterations.front().residual, &last = report.iterations.back().residual;
    return !(last.largest() < std::min(first.largest(), 0.1 * last.scale));
}

/// Where a residual is as small as rounding for the second time, and neither it nor the correction falls any more, what
/// is left of both is rounding: near a limit load the body answers to next to no force with a large displacement.
class LeftToRounding {
public:
    [[nodiscard]] bool is(const Residual& residual, double correction) {
        constexpr double rounding = 1e-11;  // of the forces that balance
        if (!residual.within(rounding)) return false;
        const bool is = residual.largest() >= 0.5 * residual_ && correction >= 0.5 * correction_;
        residual_ = residual.largest();
        correction_ = correction;
        return is;
    }

private:
    // Where the residual was as small last.
    double residual_ = std::numeric_limits<double>::infinity(), correction_ = residual_;
};

/// From one start until convergence or for as long as is allowed; false where the start turns out to mislead.
[[nodiscard]] bool iterate(Equilibrium& equilibrium, const SolverSection& solver, double largest_force, bool guessed,
                           const Waits& waits, NewtonReport& report) {
    LineSearch search;
    LeftToRounding left_to_rounding;
    for (int iteration = 0; iteration <= solver.max_iterations; ++iteration) {
        report.stopped = !waits();
        if (report.stopped) return true;
        const Residual residual = equilibrium.linearise();
        if (!residual.is_finite()) throw NumericalFailure("the residual is not a number");
        if (residual.woken) iteration = 0;  // what has been woken is new to it
        if (const double part = search.further(residual); part != 0.0) {
            report.iterations.push_back({residual, 0.0});
            equilibrium.apply_further(part);
            continue;
        }
        const double correction = equilibrium.solve();
        report.iterations.push_back({residual, correction});
        const bool settled = residual.within(solver.tolerance) &&
                             (left_to_rounding.is(residual, correction) || correction <= 10.0 * solver.tolerance);
        const bool rounding = residual.largest() < 1e-13 * largest_force && residual.target <= solver.tolerance;
        if (settled || rounding) {
            report.converged = !residual.provisional;
            if (report.converged) return true;
            equilibrium.look_at_rest();
        }
        if (guessed && is_misled(report)) return false;
        equilibrium.apply();
    }
    report.failure = fmt::format("no convergence in {} iterations", solver.max_iterations);
    return true;
}

}  // namespace

NewtonReport find_equilibrium(Equilibrium& equilibrium, const Target& target, const Predictor& predictor,
                              const SolverSection& solver, double largest_force, const Waits& waits) {
    NewtonReport report;
    const auto is_done_from = [&](const Predictor& start) {
        const bool guessed = start.goes_on || start.factor != 0.0;
        try {
            equilibrium.begin(target, start);
            return iterate(equilibrium, solver, largest_force, guessed, waits, report);
        } catch (const NumericalFailure& failure) {
            report.failure = failure.what();
            return !guessed;
        }
    };
    if (is_done_from(predictor)) return report;
    equilibrium.rollback();
    report.lost = std::exchange(report.iterations, {});
    report.failure.clear();
    static_cast<void>(is_done_from({}));
    return report;
}

}  // namespace stria::coarse
