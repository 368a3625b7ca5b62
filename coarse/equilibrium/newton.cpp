#include "coarse/equilibrium/newton.hpp"

#include <fmt/format.h>
#include <limits>

#include "coarse/equilibrium/damping.hpp"
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

NewtonReport find_equilibrium(Equilibrium& equilibrium, const Target& target, const Predictor& predictor,
                              const SolverSection& solver, double largest_force) {
    NewtonReport report;
    try {
        Damping damping;
        equilibrium.begin(target, predictor);
        for (int iteration = 0; iteration <= solver.max_iterations; ++iteration) {
            const Residual residual = equilibrium.linearise();
            if (!residual.is_finite()) throw NumericalFailure("the residual is not a number");
            const double correction = equilibrium.solve();
            report.iterations.push_back({residual, correction});
            const bool settled = residual.within(solver.tolerance) && correction <= 100.0 * solver.tolerance;
            const bool rounding = residual.largest() < 1e-13 * largest_force && residual.target <= solver.tolerance;
            if (settled || rounding) {
                report.converged = !residual.provisional;
                if (report.converged) return report;
                equilibrium.look_at_rest();
            }
            equilibrium.apply(damping.factor(residual.interior));
        }
        report.failure = fmt::format("no convergence in {} iterations", solver.max_iterations);
    } catch (const NumericalFailure& failure) {
        report.failure = failure.what();
    }
    return report;
}

}  // namespace stria::coarse
