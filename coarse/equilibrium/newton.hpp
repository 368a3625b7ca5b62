// Newton's method for one equilibrium: consistent tangents, full steps with a line search where they lead nowhere, a
// residual test and a correction test.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "coarse/equilibrium/equilibrium.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

struct NewtonIteration {
    Residual residual;
    double correction;  // relative to the largest displacement; 0: none, but one more part of the last one
};

struct NewtonReport {
    bool converged = false;
    bool stopped = false;  // as the caller wished; nothing is known of the increment
    std::vector<NewtonIteration> iterations;
    std::vector<NewtonIteration> lost;  // from what the predictor said, where that misled
    std::string failure;                // what went wrong, where it did not converge

    [[nodiscard]] bool was_misled() const { return !lost.empty(); }
    [[nodiscard]] int count() const { return static_cast<int>(iterations.size() + lost.size()); }
    /// Fixed-width table of the iterations, the lost ones first.
    [[nodiscard]] std::string table() const;
};

/// False: nobody waits for the equilibrium any more.
using Waits = std::function<bool()>;

/// When Newton's method ends.
struct NewtonLimits {
    SolverSection solver;               // tolerance, and how many iterations
    double largest_force = 0.0;         // the largest scale that this body has seen, N/mm
    Waits waits = [] { return true; };  // asked in each iteration
};

/// From where the predictor says, and without it where that leads nowhere. Converged: the largest of the three
/// residuals is at most the tolerance times the force scale, the target is met to the tolerance, and the correction
/// that is still due is at most 10 times the tolerance of the largest displacement, or is rounding. Where an elastic
/// body is without load no force balances another, and all that is left is the rounding of forces that were there:
/// residuals within 1e-13 of the largest force are nothing. `solver.max_iterations` are allowed anew from the second
/// start, from open faces where those of a body that does not flow were still changing, where elements at rest have
/// been woken, and where faces that change in the first correction have come to rest on elastic metal. Does not throw
/// on failure: the caller cuts.
NewtonReport find_equilibrium(Equilibrium& equilibrium, const Target& target, const Predictor& predictor,
                              const NewtonLimits& limits);

}  // namespace stria::coarse
