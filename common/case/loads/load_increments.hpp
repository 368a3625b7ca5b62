// Increments per cycle that follow from how the loads of a case move.
#pragma once

#include "common/case/case.hpp"

namespace stria {

/// Its load and that of [load] run along a curve, or a polygon, and not along a line.
[[nodiscard]] bool lags(const LoadCaseSection& load_case);

/// Increments of a cycle in each of which no pressure that travels goes on by more than a `part` of its half width: an
/// even number. Zero where none travels.
[[nodiscard]] int increments_of_travel(const std::vector<BoundarySection>& boundaries, double part);

/// Fills in load.steps where the case file leaves them to the program and the loads decide: where pressures travel, or
/// where load cases lag, and the load runs along a curve.
void choose_increments(Case& whole);

}  // namespace stria
