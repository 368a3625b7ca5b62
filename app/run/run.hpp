// The work behind `stria run` and the two components: composes the coarse and the fine component and runs a case.
#pragma once

#include "app/run/run_options.hpp"

namespace stria {

/// Each returns the exit code 0, or 130 where the run was interrupted, and otherwise throws (common/error.hpp).
int run_coarse_with_mpi(const RunOptions& options);  // stria-coarse; no MPI where the case needs no fine component
int run_fine_with_mpi(const RunOptions& options);    // stria-fine
int run_in_process(const RunOptions& options);       // modes inprocess and monolithic

}  // namespace stria
