// The work behind the commands: composes the coarse and the fine component and runs a case.
#pragma once

#include <string>
#include <vector>

namespace stria {

struct RunOptions {
    std::string case_path;
    std::string output_directory;  // empty: runs/<name of the case>
    std::string mode = "mpi";      // mpi | inprocess | monolithic
    int fine_ranks = 1;
    bool force = false;   // write into a folder that holds results
    bool resume = false;  // go on from its checkpoint
    bool quiet = false;
    bool verbose = false;
    std::vector<std::string> overrides;  // key=value
};

/// Each returns the exit code 0, or 130 where the run was interrupted, and otherwise throws (common/error.hpp).
int run_coarse_with_mpi(const RunOptions& options);  // stria-coarse; no MPI where the case needs no fine component
int run_fine_with_mpi(const RunOptions& options);    // stria-fine
int run_in_process(const RunOptions& options);       // modes inprocess and monolithic
int check(const RunOptions& options);                // prints case, mesh and cost, solves nothing

}  // namespace stria
