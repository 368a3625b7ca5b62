// Starts the two components of a run under mpirun and waits for them.
#pragma once

#include "app/run/run_options.hpp"

#include <string>
#include <vector>

namespace stria {

/// Reads the case, fills in the default folder of results, makes it, and refuses one that already holds results, unless
/// the run is to be resumed. Throws CaseError.
void claim_output_directory(RunOptions& options);

/// The command that runs the case in mode mpi; programs are looked for in `programs`.
std::vector<std::string> launch_command(const RunOptions& options, const std::string& programs, bool with_fine);

/// Runs it with the environment Open MPI needs and returns its exit code: 4 where a component was lost.
int launch(const RunOptions& options);

/// `stria run` with these options as a child whose output goes to the file `log`; its exit code: 4 where it crashed,
/// 130 where the user has interrupted it or, before it was started, us.
int launch_logged(const RunOptions& options, const std::string& log);

}  // namespace stria
