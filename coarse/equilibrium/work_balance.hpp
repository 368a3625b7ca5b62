// Whether the work that goes into the body comes out again: stored, dissipated, or released by its growing cracks.
#pragma once

#include <cmath>

#include "coarse/equilibrium/equilibrium.hpp"
#include "coarse/structure/structure.hpp"
#include "coupling/messages.hpp"

namespace stria::coarse {

/// Of the whole body so far, N (per mm of thickness). All that must be kept to go on from a converged increment.
struct WorkBalance {
    double external = 0.0;     // done by loads and imposed displacements
    double largest = 0.0;      // that it has been, by magnitude
    Eigen::VectorXd by_cases;  // its shares of the load cases; empty before the first increment
    double stored = 0.0;       // elastic energy and what hardening holds: of the present state
    double dissipated = 0.0;   // by plastic flow and friction
    double by_friction = 0.0;  // its share
    double released = 0.0;     // by faces that growth has opened

    double at_start = 0.0;  // stored and dissipated when the initial stress had come to equilibrium: nobody's work

    // Where the last increment ended.
    double load_factor = 0.0;
    double load_displacement = 0.0;  // what the structure's unit loads do work on, N
    double imposed_force = 0.0;      // what unit imposed displacements do work against, N
    Eigen::VectorXd cases = {}, case_displacements = {}, case_forces = {};  // likewise, of each load case

    /// What trapezoids and backward Euler leave over: of second order in the increments.
    [[nodiscard]] double error() const { return external + at_start - stored - dissipated - released; }
    // Shares that the error has; NaN where there is no such work.
    [[nodiscard]] double share_of_largest() const { return std::abs(error()) / largest; }
    [[nodiscard]] double share_of_lost() const { return std::abs(error()) / (dissipated + std::abs(released)); }
};

/// Adds an increment that ended at `u` (of the whole mesh; Gamma is looked at), with what a testing machine reads
/// there.
void add_increment(WorkBalance& balance, const Structure& structure, const Eigen::VectorXd& u,
                   const LoadFactors& factors, const MachineReading& machine, const coupling::StepReport& zone);

/// The initial stress has come to equilibrium: the balance begins here.
void begin_here(WorkBalance& balance);

/// The structure has given elements to the zone, at the committed `u`.
void restart(WorkBalance& balance, const Structure& structure, const Eigen::VectorXd& u);

}  // namespace stria::coarse
