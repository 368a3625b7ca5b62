#include "app/study/runner.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

#include "app/process/exit_code.hpp"
#include "app/process/version.hpp"
#include "app/results/run_files.hpp"
#include "app/run/launch.hpp"
#include "app/run/run_lock.hpp"
#include "app/study/plan.hpp"
#include "coarse/results/result_files.hpp"
#include "common/case/case_questions.hpp"
#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"
#include "common/io/checksum.hpp"

namespace stria::study {

namespace result_files = coarse::result_files;

namespace {

/// The last complaint in what a run has said: a line "stria...: ..."; without one, its last line.
std::string complaint_in(const std::filesystem::path& log) {
    std::ifstream file(log);
    std::string complaint, last;
    for (std::string line; std::getline(file, line);) {
        if (line.empty()) continue;
        last = line;
        if (line.starts_with("stria")) complaint = line;
    }
    return complaint.empty() ? last : complaint;
}

RunStatus status_of(int exit_code) {
    switch (exit_code) {
    case Done:
        return RunStatus::Done;
    case InputWrong:
        return RunStatus::WrongInput;
    case NumbersFailed:
        return RunStatus::Failed;
    case LostComponent:
        return RunStatus::Lost;
    case FileFailed:
        return RunStatus::NoFile;
    case Interrupted:
        return RunStatus::Interrupted;
    default:
        return RunStatus::Error;
    }
}

/// What the folder holds of the same case, computed in the same way and by the same program.
enum class Found { Nothing, Begun, Done };

Found found_in(const RunOptions& options) {
    const std::filesystem::path folder = options.output_directory;
    const Case input = read_case(options.case_path, options.overrides);
    if (read_text(folder / result_files::resolved_case) != resolved_toml(input)) return Found::Nothing;
    const JsonObject summary = read_json(folder / result_files::summary);
    if (summary.words.empty()) return Found::Begun;  // it is written last
    const auto [fine_ranks, processes] = parts_of(options, needs_fine(input));
    if (summary.word("version") != version_text() || summary.word("mode") != to_text(options.mode) ||
        summary.number("ranks") != processes || summary.number("fine_ranks") != fine_ranks)
        return Found::Nothing;
    // The case names its mesh: what is in the file may be another one since.
    if (input.mesh.file && summary.word("mesh_file") != checksum_of(*input.mesh.file)) return Found::Nothing;
    return coarse::run_status(summary.word("status")) == RunStatus::Done ? Found::Done : Found::Begun;
}

/// Makes the folder. Results of an earlier run must not be taken for those of one that dies before it writes any.
/// Throws CaseError where a run is writing there.
void make_ready(const RunOptions& options) {
    const std::filesystem::path folder = options.output_directory;
    std::filesystem::create_directories(folder);
    const RunLock lock(folder);
    if (!options.resume) coarse::remove_results(folder);
}

Outcome outcome_of(const std::filesystem::path& folder, int code) {
    Outcome outcome = read_outcome(folder);
    outcome.exit_code = code;
    outcome.status = status_of(code);
    if (code != Done && code != Interrupted) outcome.message = complaint_in(folder / log_name);
    return outcome;
}

bool is_written_to(const std::filesystem::path& folder) {
    if (!std::filesystem::exists(folder)) return false;
    try {
        const RunLock lock(folder);
        return false;
    } catch (const CaseError&) {
        return true;
    }
}

/// Of a run that others make. One that has failed says so in its log.
Outcome outcome_so_far(const RunOptions& options) {
    if (is_written_to(options.output_directory)) return {.status = RunStatus::Running};
    Outcome outcome;
    if (found_in(options) != Found::Nothing) outcome = read_outcome(options.output_directory);
    if (outcome.status == RunStatus::Failed)
        outcome = outcome_of(options.output_directory, NumbersFailed);
    else if (outcome.status == RunStatus::Interrupted)
        outcome.exit_code = Interrupted;
    return outcome;
}

}  // namespace

Runner::Runner(RunOptions shared, bool resume, int jobs)
    : shared_(std::move(shared)), resume_(resume), jobs_(jobs), cores_(own_cores()),
      terminal_(isatty(STDOUT_FILENO) != 0) {}

void Runner::run(std::span<Row* const> rows, const std::function<void()>& changed) {
    count_ = rows.size();
    std::size_t next = 0;
    if (jobs_ == 0)
        for (Row* row : rows) row->outcome = outcome_so_far(options_of(*row));
    while (jobs_ > 0) {
        while (next < rows.size() && std::ssize(running_) < jobs_ && !interrupted_) {
            begin(*rows[next], next + 1);
            ++next;
        }
        if (running_.empty()) return;
        changed();
        say_how_far();
        end(wait_for_child());
    }
}

RunOptions Runner::options_of(const Row& row) const {
    RunOptions options = run_options(shared_, row.settings);
    options.output_directory = (std::filesystem::path(shared_.output_directory) / row.folder).string();
    options.quiet = false;  // into its log
    return options;
}

void Runner::begin(Row& row, std::size_t number) {
    interrupted_ = interrupted_ || asked_to_end();
    if (interrupted_) return;
    RunOptions options = options_of(row);
    const Found found = resume_ ? found_in(options) : Found::Nothing;
    if (found == Found::Done) {
        row.outcome = read_outcome(options.output_directory);
        say(row, number, "done before");
        return;
    }
    options.resume = found == Found::Begun && coarse::has_checkpoint(options.output_directory);
    try {
        make_ready(options);
    } catch (const CaseError& taken) {
        row.outcome = {.status = status_of(InputWrong), .message = taken.what(), .exit_code = InputWrong};
        say(row, number, to_text(row.outcome.status) + ": " + row.outcome.message);
        return;
    }
    const int part = free_part();
    const std::string log = (std::filesystem::path(options.output_directory) / log_name).string();
    const pid_t process = start_child(run_command(options), {.log = log, .cores = share_of(cores_, part, jobs_)});
    running_[process] = {&row, number, part, std::chrono::steady_clock::now()};
    row.outcome.status = RunStatus::Running;
}

void Runner::end(const EndedChild& child) {
    const auto found = running_.find(child.process);
    if (found == running_.end()) return;
    const Job job = found->second;
    running_.erase(found);
    Row& row = *job.row;
    row.outcome = outcome_of(options_of(row).output_directory, child.ours ? child.code : LostComponent);
    interrupted_ = interrupted_ || row.outcome.exit_code == Interrupted;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - job.start).count();
    const std::string why = row.outcome.message.empty() ? "" : ": " + row.outcome.message;
    say(row, job.number, fmt::format("{} in {:.1f} s{}", to_text(row.outcome.status), seconds, why));
}

int Runner::free_part() const {
    int part = 0;
    const auto taken = [&](const auto& running) { return running.second.part == part; };
    while (std::ranges::any_of(running_, taken)) ++part;
    return part;
}

void Runner::say(const Row& row, std::size_t number, const std::string& what) const {
    if (shared_.quiet) return;
    fmt::print("{}run {} of {}  {}  {}\n", terminal_ ? "\r\033[K" : "", number, count_, to_text(row.settings), what);
    std::fflush(stdout);
}

void Runner::say_how_far() const {
    if (shared_.quiet || !terminal_) return;
    const Job& first = running_.begin()->second;
    const std::string others = running_.size() > 1 ? fmt::format(" and {} more", running_.size() - 1) : "";
    fmt::print("\r\033[Krun {} of {}  {}{} ...\r", first.number, count_, to_text(first.row->settings), others);
    std::fflush(stdout);
}

}  // namespace stria::study
