// The end of an increment: its target, what starts it, and what of the load history ends there.
#pragma once

#include "coarse/load/target.hpp"
#include "common/predictor.hpp"

namespace stria::coarse {

struct LoadStep {
    int cycle = 0;        // 0: the ramp
    double moment = 0.0;  // in cycles: c where cycle c ends, half a cycle earlier at its minimum; below 0 on the ramp
    Target target;
    Predictor predictor;          // predictor_from() the increments taken before
    bool reversal = false;        // a half cycle ends here
    bool bends = false;           // the loads go on in another direction
    double next_over_this = 1.0;  // sizes of increments, each in parts of what it is without halvings
    bool at_maximum = false, at_minimum = false,
         at_zero = false;  // extremes of the cycle, and the step nearest to a target of zero
    bool ends_cycle = false;
    bool settles = false;   // the initial stress comes to equilibrium, without load
    bool releases = false;  // faces that growth has opened come to equilibrium, under the loads that are reached

    [[nodiscard]] bool at_extreme() const { return at_maximum || at_minimum || at_zero; }
};

}  // namespace stria::coarse
