// A converged increment of the load, as those who record and measure get it.
#pragma once

#include <vector>

#include "coarse/cycle/closure_meter.hpp"
#include "coarse/cycle/cycle_result.hpp"
#include "coarse/equilibrium/newton.hpp"
#include "coarse/equilibrium/work_balance.hpp"
#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/load/load_controller.hpp"

namespace stria::coarse {

struct Increment {
    int number = 0;  // from 1
    LoadStep step;
    double load_factor = 0.0;                    // found, where a displacement is controlled
    std::vector<OpeningChange> opening_changes;  // on the way to this increment
    std::vector<double> signal;                  // ClosureMeter::signal()
    NewtonReport newton;
    const Equilibrium* equilibrium = nullptr;  // in the state committed, as long as the listener runs
    MachineReading machine;
    coupling::StepReport zone;
    std::vector<TipResult> tips;
    std::vector<double> nominal_K;    // K_1(a) of every tip: elastic, traction-free faces, load factor 1, this length
    std::vector<double> K_initial;    // likewise of the initial stress without load; empty: there is none
    WorkBalance work;                 // so far
    std::vector<CycleResult> cycles;  // one per tip where a cycle ends here

    [[nodiscard]] double initial_K(std::size_t tip) const { return K_initial.empty() ? 0.0 : K_initial[tip]; }
    /// Nominal K of a tip at a load factor, that of the initial stress included.
    [[nodiscard]] double K_at(std::size_t tip, double at_load_factor) const {
        return nominal_K[tip] * at_load_factor + initial_K(tip);
    }
};

}  // namespace stria::coarse
