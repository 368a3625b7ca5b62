// Cycles of a crack as a meter sees them, increment by increment.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "coarse/cycle/cycle_meter.hpp"

namespace stria::coarse {

class CycleMeterTest : public testing::Test {
protected:
    CycleMeterTest() {
        input.material.yield_stress = 300.0;
        closure = ClosureMeter(input.closure, {300.0}, input.cracks, {500.0});
        input.cracks.emplace_back().contact.emplace();
        meter = CycleMeter(input, closure, tips);
    }

    /// At a load of the crack `a` long.
    void go(int cycle, double load, double a, bool is_closed, std::vector<OpeningChange> changes = {}) {
        Increment increment;
        increment.step.cycle = cycle;
        increment.step.moment = moment;
        if (input.load.control == Control::Displacement && !moved_to)
            increment.step.target.control = Control::Displacement;
        increment.machine.displacement = moved_to.value_or(load);
        if (force_of_load) increment.machine.imposed_force = force_of_load(load);
        increment.step.target.value = increment.load_factor = load;
        increment.cases_before = std::exchange(cases_before, cases);
        increment.step.target.cases = cases;
        increment.nominal = {{.K_I = told ? unit_K * a : NAN, .K_II = unit_K_II, .K_initial = initial_K}};
        increment.nominal[0].K_I_of_cases.assign(static_cast<std::size_t>(cases.size()), 10.0 * a);
        increment.signal.assign(closure.signals().all(), is_closed ? 1.0 : -1.0);
        increment.opening_changes = std::move(changes);
        increment.tips.push_back({.a = a,
                                  .x = way * a,
                                  .way = bend + way * a,
                                  .J = J_of_load * load,
                                  .CTOD = 1e-3 * load,
                                  .CMOD = mouth_of_load ? mouth_of_load(load) : load,
                                  .opening = 2e-3 * load + opening_at_tip,
                                  .plastic_zone = 0.01 * load});
        if (is_beside_another) {
            increment.nominal.push_back(increment.nominal[0]);
            increment.signal.insert(increment.signal.end(), increment.signal.begin(), increment.signal.end());
            increment.tips.push_back({.a = 3.0});
        }
        meter.add(increment);
    }

    Case input;
    ClosureMeter closure;
    CycleMeter meter;
    const std::vector<Tip> tips{{0, Vec2::Zero(), Vec2::UnitX(), 1.0, 0}};
    double unit_K = 10.0, unit_K_II = 0.0;  // of a crack of 1 mm
    Eigen::VectorXd cases, cases_before;    // factors of load cases
    double initial_K = 0.0, way = 1.0;      // of the tip, over the length that the crack is said to have
    double bend = 0.0;                      // mm: by so much its way is longer than straight
    double opening_at_tip = 0.0;            // beside what the load makes
    bool is_beside_another = false;         // tip, which stands, and has the same K
    bool told = true;                       // K, by a ring
    double J_of_load = 1.0;
    std::function<double(double)> mouth_of_load;  // mm; absent: the load
    std::function<double(double)> force_of_load;  // that holds what is moved, N; absent: nothing is
    double moment = 1.0;                          // cycles
    std::optional<double> moved_to;               // mm, the boundary, by what is no displacement controlled
};

}  // namespace stria::coarse
