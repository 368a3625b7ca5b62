// The sections of a case that the zone reads.
#pragma once

#include <vector>

#include "common/case/case.hpp"
#include "common/material/materials.hpp"

namespace stria::fine {

struct ZoneSections {
    ZoneSections(const Case& input)
        : materials(input), cracks(input.cracks), fine(input.fine), steps_per_cycle(input.load.steps),
          tolerance(input.solver.tolerance) {}

    Materials materials;
    std::vector<CrackSection> cracks;
    FineSection fine;
    OrAuto<int> steps_per_cycle;  // increments: how many predictors are remembered
    double tolerance;             // relative residual
};

}  // namespace stria::fine
