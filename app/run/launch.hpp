// Starts the two components of a run under mpirun and waits for them.
#pragma once

#include "app/run/run_options.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace stria {

/// Fills in the default folder of results and makes it. Throws CaseError where the case is wrong, and where the folder
/// already holds results and the run is neither forced nor resumed.
void claim_output_directory(RunOptions& options);

/// Fine ranks of a run, and its processes beside those of mpirun. Neither case nor mode may want a fine rank. In mode
/// mpi the structure has a process to itself beside a single rank; of several ranks one lives with it.
struct RunParts {
    int fine_ranks = 0, processes = 1;
};
RunParts parts_of(const RunOptions& options, bool with_fine);

/// How messages go between processes on one machine of which /dev/shm takes `room` bytes more.
enum class WayOfMessages { Memory, Loopback, None };
WayOfMessages way_of_messages(int processes, std::uint64_t room);

/// The words of the command that runs the case in mode mpi. `programs`: the folder of the two components.
std::vector<std::string> launch_command(const RunOptions& options, const std::string& programs, bool with_fine);

/// Runs that command with the environment that Open MPI needs. Returns its exit code. Throws ComponentLost where
/// a component was lost, FileFailure where the machine has no room for their messages or a program is not there.
int launch(const RunOptions& options);

/// The words of `stria run` with these options, by this program.
std::vector<std::string> run_command(const RunOptions& options);

}  // namespace stria
