// The work behind `stria check`.
#pragma once

#include "app/run/run_options.hpp"

namespace stria {

/// Prints the case with its defaults, the mesh, the handbook's values and the size of the zone; solves one elastic
/// load. Returns the exit code 0; throws CaseError where the case is wrong.
int check(const RunOptions& options);

}  // namespace stria
