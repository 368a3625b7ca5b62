// A converged increment of the load, as those who record and measure get it.
#pragma once

#include <cmath>
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
    Eigen::VectorXd cases_before = {};           // factors of the load cases where it began
    std::vector<OpeningChange> opening_changes;  // on the way to this increment
    std::vector<double> signal;                  // ClosureMeter::signal()
    NewtonReport newton;
    const Equilibrium* equilibrium = nullptr;  // in the state committed, as long as the listener runs
    MachineReading machine;
    coupling::StepReport zone;
    std::vector<TipResult> tips;
    std::vector<double> nominal_K;  // K_1(a) of every tip: elastic, traction-free faces, load factor 1, this length
    std::vector<double> K_initial;  // likewise of the initial stress without load; empty: there is none
    std::vector<std::vector<double>> K_of_cases = {};  // likewise of each load case at its factor 1
    WorkBalance work;                                  // so far
    std::vector<CycleResult> cycles;                   // one per tip where a cycle ends here
    std::vector<TipResult> nominal = {};               // likewise: K_1(a) of both modes, and of each load case

    [[nodiscard]] double initial_K(std::size_t tip) const { return K_initial.empty() ? 0.0 : K_initial[tip]; }
    /// Nominal K of a tip that load cases and the initial stress have at a part of the way.
    [[nodiscard]] double K_beside(std::size_t tip, double way = 1.0) const {
        if (K_of_cases.empty()) return initial_K(tip);
        return std::lerp(sum_over_cases(K_of_cases[tip], cases_before),
                         sum_over_cases(K_of_cases[tip], step.target.cases), way) +
               initial_K(tip);
    }
    /// Nominal K of a tip under any loads.
    [[nodiscard]] double K_under(std::size_t tip, const LoadFactors& loads) const {
        const double of_cases = K_of_cases.empty() ? 0.0 : sum_over_cases(K_of_cases[tip], loads.cases);
        return nominal_K[tip] * loads.main + of_cases + initial_K(tip);
    }
    /// Nominal K of a tip at its end, and at a change on the way.
    [[nodiscard]] double K_at_end(std::size_t tip) const { return nominal_K[tip] * load_factor + K_beside(tip); }
    [[nodiscard]] double K_at(std::size_t tip, const OpeningChange& change) const {
        return nominal_K[tip] * change.load_factor + K_beside(tip, change.way);
    }
};

}  // namespace stria::coarse
