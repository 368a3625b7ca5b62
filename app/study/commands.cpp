#include "app/study/commands.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "app/process/children.hpp"
#include "app/run/launch.hpp"
#include "app/study/runner.hpp"
#include "common/case/case_questions.hpp"
#include "common/case/schema/case_file.hpp"

namespace stria::study {

namespace {

/// Runs in the order in which Runner begins them.
std::vector<RunOptions> runs_of(const StudyOptions& options, const Plan& plan) {
    std::vector<RunOptions> runs;
    const std::filesystem::path folder = std::filesystem::absolute(options.run.output_directory);
    for (const auto* rows : {&plan.references, &plan.variants})
        for (const Row& row : *rows) {
            RunOptions run = run_options(options.run, row.settings);
            run.case_path = std::filesystem::absolute(run.case_path).lexically_normal().string();
            run.output_directory = (folder / row.folder).lexically_normal().string();
            run.resume = true;
            run.quiet = false;
            runs.push_back(run);
        }
    return runs;
}

/// `start`: what stands before the command: "exec " puts the run in the place of the shell.
std::string line_of(const RunOptions& run, const std::string& start) {
    const std::string& folder = run.output_directory;
    return fmt::format("mkdir -p {} && {}{} > {} 2>&1", quoted(folder), start, quoted(run_command(run)),
                       quoted((std::filesystem::path(folder) / log_name).string()));
}

/// sbatch takes fewer letters in its lines than a shell does.
std::string job_name(const StudyOptions& options) {
    std::string name = std::filesystem::path(options.run.output_directory).filename().string();
    std::ranges::replace_if(
        name, [](unsigned char letter) { return std::isalnum(letter) == 0 && letter != '-'; }, '_');
    return name;
}

constexpr const char* script = R"(#!/bin/bash
# A job array of {count} runs. Submit it with sbatch, which takes --time, --partition and the like as well. While it
# runs, and at its end, "stria study ..." with --resume --jobs 0 makes the table and the page of what is done.
#SBATCH --job-name={name}
#SBATCH --array=1-{count}
#SBATCH --nodes=1
#SBATCH --ntasks={processes}
#SBATCH --requeue
#SBATCH --signal=B:TERM@120
#SBATCH --output=/dev/null

case ${{SLURM_ARRAY_TASK_ID:?is given by sbatch}} in
{tasks}*) echo "there is no run $SLURM_ARRAY_TASK_ID" >&2; exit 2 ;;
esac
)";

}  // namespace

std::string command_lines(const StudyOptions& options, const Plan& plan) {
    std::string text;
    for (const RunOptions& run : runs_of(options, plan)) text += line_of(run, "") + '\n';
    return text;
}

std::string job_array(const StudyOptions& options, const Plan& plan) {
    std::string tasks;
    int count = 0, processes = 1;
    for (const RunOptions& run : runs_of(options, plan)) {
        tasks += fmt::format("{}) {} ;;\n", ++count, line_of(run, "exec "));
        processes = std::max(processes, parts_of(run, needs_fine(read_case(run.case_path, run.overrides))).processes);
    }
    return fmt::format(fmt::runtime(script), fmt::arg("count", count), fmt::arg("name", job_name(options)),
                       fmt::arg("processes", processes), fmt::arg("tasks", tasks));
}

}  // namespace stria::study
