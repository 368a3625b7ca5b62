// The sections of a case that the zone reads.
#pragma once

#include <vector>

#include "common/case/case.hpp"
#include "common/integration/zone_rule.hpp"
#include "common/material/materials.hpp"

namespace stria::fine {

struct ZoneSections {
    ZoneSections(const Case& input)
        : materials(input), cracks(input.cracks), fine(input.fine), steps_per_cycle(input.load.steps),
          tolerance(input.solver.tolerance) {}

    [[nodiscard]] IntegrationRule rule() const { return zone_rule(fine, materials.may_yield()); }

    /// Plastic strain in an increment below which elements keep their elastic tangent. A wake flows a little over and
    /// over, and all fronts above it would be factored for that. What their own tangent would take off a residual is
    /// left by the next correction alone; where corrections do not get there soon, none keeps it.
    [[nodiscard]] double slight_flow(int corrections) const {
        constexpr double of_tolerance = 0.05;
        return corrections < 4 ? of_tolerance * tolerance : 0.0;
    }

    Materials materials;
    std::vector<CrackSection> cracks;
    FineSection fine;
    OrAuto<int> steps_per_cycle;  // increments: how many predictors are remembered
    double tolerance;             // relative residual
};

}  // namespace stria::fine
