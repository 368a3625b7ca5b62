// The work behind `stria material`.
#pragma once

#include "app/run/run_options.hpp"

namespace stria::material {

/// Drives one point of the case's material through the cycles of [material_test], prints a table of cycles and leaves
/// loop.csv, cycles.csv and loop.svg in the folder of results. Returns the exit code 0; throws CaseError,
/// NumericalFailure and FileFailure.
int test_material(const RunOptions& options);

}  // namespace stria::material
