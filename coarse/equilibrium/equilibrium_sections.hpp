// What equilibrium reads of a case.
#pragma once

#include "common/case/case.hpp"

namespace stria::coarse {

struct EquilibriumSections {
    OrAuto<int> steps;  // increments per cycle
    double tolerance;   // of the relative residual
    CouplingSection coupling;

    EquilibriumSections(const Case& input)  // NOLINT(google-explicit-constructor): a view of the case
        : steps(input.load.steps), tolerance(input.solver.tolerance), coupling(input.coupling) {}
};

}  // namespace stria::coarse
