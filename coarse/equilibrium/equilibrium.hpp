// Newton's view of a nonlinear system on its way to one target: condensed across two components, or monolithic. The
// load factor is one of its unknowns.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "coarse/load/load_factors.hpp"
#include "coarse/load/target.hpp"
#include "coarse/structure/coarse_effort.hpp"
#include "coarse/structure/far_displacement.hpp"
#include "coupling/messages.hpp"

namespace stria::coarse {

/// How far the trial state is from equilibrium. Residuals are largest nodal forces, N/mm.
struct Residual {
    double boundary = 0.0;                   // on the unknowns of the structure, where a zone is condensed with what is
                                             // out of balance inside it: what its correction has to balance
    double nodal = 0.0;                      // likewise, but as the nodes feel it: the same however it is solved
    double interior = 0.0;                   // inside the zone
    double contact = 0.0;                    // complementarity
    double scale = 0.0;                      // the forces that balance
    double target = 0.0;                     // of what is controlled, relative to its target
    double along = 0.0, along_before = 0.0;  // work of what is out of balance along the last correction, taken whole,
                                             // N: here, and where that correction began; zero: not known
    int yielding_points = 0;
    int closed = 0;                               // multipliers
    int status_changes = 0;                       // since the iteration before
    bool keeps_factor = false;                    // its correction takes the tangent of the iterate before
    bool provisional = false;                     // elements at rest have not been looked at: no state to stay in
    bool woken = false;                           // some of them have been found to yield: they take part from here on
    std::vector<std::vector<double>> faces = {};  // per tip and distance behind it: coupling::Digest
    std::vector<double> opening = {};             // per tip, mm; NaN where the zone does not hold the place
    std::vector<double> force_ahead = {};  // per tip, where it is measured: normal stress over the sector ahead, N
    std::vector<std::vector<coupling::NearestContact>> nearest = {};  // likewise, per distance behind it

    [[nodiscard]] double largest() const { return std::max({boundary, interior, contact}); }
    [[nodiscard]] double largest_nodal() const { return std::max({nodal, interior, contact}); }
    [[nodiscard]] bool is_finite() const { return std::isfinite(boundary + interior + contact + target); }
    [[nodiscard]] bool within(double tolerance) const { return largest() <= tolerance * scale && target <= tolerance; }
};

/// All that an equilibrium remembers of what is committed, but for the zone's part.
struct EquilibriumState {
    double load_factor = 0.0;
    Eigen::VectorXd cases = {};               // factors of the load cases
    Eigen::VectorXd displacement;             // of Gamma, mm
    std::vector<Eigen::VectorXd> increments;  // of Gamma, for predictors; the last one first
    std::vector<double> load_increments;      // likewise, of the load factor
    Eigen::VectorXd whole;                    // of the whole mesh; empty where only Gamma is solved for
    std::vector<Eigen::VectorXd> whole_increments;
};

/// What a testing machine reads at the loaded boundary, along its direction.
struct MachineReading {
    double displacement = 0.0;                     // mean, mm
    double force = 0.0;                            // of the supports that hold it, N/mm; zero where forces load it
    double imposed_force = 0.0;                    // what unit imposed displacements do work against, N
    Eigen::VectorXd imposed_forces_of_cases = {};  // likewise, of each load case
};

/// begin(), linearise() and solve() may throw NumericalFailure: a return mapping or a factor fails, or a part of
/// the body moves freely. A rollback() makes it whole again.
class Equilibrium {
public:
    Equilibrium() = default;
    Equilibrium(const Equilibrium&) = delete;
    Equilibrium& operator=(const Equilibrium&) = delete;
    virtual ~Equilibrium() = default;

    /// Trial state = what the predictor says, on the way to a target.
    virtual void begin(const Target& target, const Predictor& predictor) = 0;

    /// Evaluates the trial state and its tangent.
    virtual Residual linearise() = 0;

    /// Newton's correction of the linearised state: its largest displacement relative to the largest displacement there
    /// is (1 at the start of a run).
    virtual double solve() = 0;

    /// The next state may be the last: elements at rest are to be looked at, so that it is not provisional.
    virtual void look_at_rest() {}

    /// Of all that is evaluated until the next begin(), or until told otherwise: metal answers elastically, whatever
    /// its stress.
    virtual void set_elastic(bool elastic) = 0;

    /// Takes the correction.
    virtual void apply() = 0;

    /// Takes one more part of the correction that was applied last, everywhere the same; below zero: gives it back.
    virtual void apply_further(double part) = 0;

    /// The trial state is wanted again: Predictor with `back` 0 leads there, until the next commit. To be called before
    /// the rollback.
    virtual void put_aside() = 0;

    /// Lets the commit() that must follow begin, where somebody else has a part in it.
    virtual void begin_commit(const coupling::Commit& /*what*/) {}

    /// Trial becomes committed.
    virtual coupling::StepReport commit(const coupling::Commit& what) = 0;
    virtual void rollback() = 0;

    /// Of the trial state.
    [[nodiscard]] virtual LoadFactors factors() const = 0;
    [[nodiscard]] double load_factor() const { return factors().main; }

    /// How many points flow in the trial state, per element of the zone, ascending; empty without one.
    [[nodiscard]] virtual const std::vector<std::int32_t>& yielding_points() const = 0;

    /// Displacement of the whole mesh, of the trial state; unknowns inside the zone are zero. Dear on a large mesh.
    [[nodiscard]] virtual Eigen::VectorXd structure_displacement() const = 0;

    /// The same, and what is far where somebody wants it.
    [[nodiscard]] virtual DisplacementBesideFar displacement_beside_far() const {
        return {structure_displacement(), nullptr};
    }

    /// The same where near elements see it; elsewhere anything. Valid until the trial state changes.
    [[nodiscard]] virtual const Eigen::VectorXd& near_displacement() const = 0;

    /// Of the trial state.
    [[nodiscard]] virtual MachineReading machine_reading() const = 0;

    /// Between increments.
    [[nodiscard]] virtual EquilibriumState state() const = 0;
    virtual void restore(const EquilibriumState& state) = 0;

    /// Its part of the coarse effort: solves, and the time of the exchange with the zone.
    [[nodiscard]] virtual CoarseEffort effort() const { return {}; }
};

}  // namespace stria::coarse
