// The runs of a study as commands, for whoever runs them elsewhere: by hand, side by side, on a cluster.
#pragma once

#include <string>

#include "app/study/plan.hpp"

namespace stria::study {

/// One line for each run, the references first: it makes the run's folder, goes on from a checkpoint that is there, and
/// keeps what it says in its log. All paths are absolute, so that it does not matter where it is typed. `stria study`
/// with --resume keeps what has been done so.
std::string command_lines(const StudyOptions& options, const Plan& plan);

/// The same as a script for sbatch of Slurm: task k of its array is line k. Before its time is over a run is told, and
/// writes a checkpoint; a task that is submitted again goes on from there.
std::string job_array(const StudyOptions& options, const Plan& plan);

}  // namespace stria::study
