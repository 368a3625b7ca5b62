// A converged increment of the load, as those who record and measure get it.
#pragma once

#include <vector>

#include "coarse/cycle/closure_meter.hpp"
#include "coarse/cycle/cycle_result.hpp"
#include "coarse/equilibrium/newton.hpp"
#include "coarse/equilibrium/work_balance.hpp"
#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/load/load_step.hpp"

namespace stria::coarse {

struct Increment {
    int number = 0;  // from 1
    LoadStep step;
    double load_factor = 0.0;                    // found, where a displacement is controlled
    Eigen::VectorXd cases_before = {};           // factors of the load cases where it began
    std::vector<OpeningChange> opening_changes;  // on the way to this increment
    std::vector<double> signal;                  // ClosureMeter::signal()
    NewtonReport newton;
    const Equilibrium* equilibrium = nullptr;  // in the state committed, as long as the listener runs
    MachineReading machine;
    coupling::StepReport zone;
    std::vector<TipResult> tips;
    std::vector<TipResult> nominal;   // elastic, traction-free faces, this length: of each load at its factor 1
    WorkBalance work;                 // so far
    std::vector<CycleResult> cycles;  // one per tip where a cycle ends here

    /// Nominal K_I of a tip at its end, and at a change on the way, MPa sqrt(mm).
    [[nodiscard]] double K_at_end(std::size_t tip) const {
        return K_I_under(nominal[tip], {load_factor, step.target.cases});
    }
    [[nodiscard]] double K_at(std::size_t tip, const OpeningChange& change) const {
        return K_I_under(nominal[tip], {change.load_factor, between(cases_before, step.target.cases, change.way)});
    }
};

}  // namespace stria::coarse
