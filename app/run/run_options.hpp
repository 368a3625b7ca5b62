// What the user asked for where a case is run or checked; the same for all three programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/results/run_mode.hpp"

namespace stria {

struct RunOptions {
    std::string case_path;
    std::string output_directory;  // empty: runs/<name of the case>
    RunMode mode = RunMode::Mpi;
    int fine_ranks = 1;
    bool own_rank = false;  // of stria-coarse: one fine rank more lives in its process
    bool force = false;     // write into a folder that holds results
    bool resume = false;    // go on from its checkpoint
    bool quiet = false;
    bool verbose = false;
    bool report = true;                  // report.html at the end
    std::optional<double> max_seconds;   // then the run ends as if interrupted
    std::vector<std::string> overrides;  // key=value
};

}  // namespace stria
