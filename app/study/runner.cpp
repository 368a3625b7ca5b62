#include "app/study/runner.hpp"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

#include "app/process/exit_code.hpp"
#include "app/process/version.hpp"
#include "app/run/launch.hpp"
#include "app/run/run_files.hpp"
#include "app/study/plan.hpp"
#include "common/case/case_file.hpp"

namespace stria::study {

namespace {

const char* const log_name = "stria.log";

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

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

std::string status_of(int exit_code) {
    switch (exit_code) {
    case Done:
        return "done";
    case InputWrong:
        return "wrong input";
    case NumbersFailed:
        return "failed";
    case LostComponent:
        return "lost";
    case FileFailed:
        return "no file";
    case Interrupted:
        return "interrupted";
    default:
        return "error";
    }
}

/// The folder holds the finished run of the same case, in the same way and by the same program.
bool is_done(const RunOptions& options) {
    const std::filesystem::path folder = options.output_directory;
    const JsonObject summary = read_json(folder / "summary.json");
    const auto is = [&](const char* name, const std::string& word) {
        const auto found = summary.words.find(name);
        return found != summary.words.end() && found->second == word;
    };
    const Case input = read_case(options.case_path, options.overrides);
    const int ranks = options.mode == "mpi" && needs_fine(input) ? 1 + options.fine_ranks : 1;
    const auto found = summary.numbers.find("ranks");
    return is("status", "done") && is("version", version_text()) && is("mode", options.mode) &&
           found != summary.numbers.end() && found->second == ranks &&
           text_of(folder / "case.resolved.toml") == resolved_toml(input);
}

void perform(const RunOptions& options, Row& row) {
    const std::filesystem::path folder = options.output_directory;
    // Results of an earlier run must not be taken for those of one that dies before it writes any.
    for (const char* file : {"summary.json", "history.csv", "faces.csv"}) std::filesystem::remove(folder / file);
    std::filesystem::create_directories(folder);
    const int code = launch_logged(options, (folder / log_name).string());
    row.outcome = read_outcome(folder);
    row.outcome.exit_code = code;
    row.outcome.status = status_of(code);
    if (code != Done && code != Interrupted) row.outcome.message = complaint_in(folder / log_name);
}

}  // namespace

Runner::Runner(RunOptions shared, bool resume, std::size_t count)
    : shared_(std::move(shared)), resume_(resume), count_(count), terminal_(isatty(STDOUT_FILENO) != 0) {}

void Runner::say(const std::string& text, const char* end) const {
    if (shared_.quiet) return;
    fmt::print("{}{}", text, end);
    std::fflush(stdout);
}

void Runner::run(Row& row) {
    ++begun_;
    if (interrupted_) return;
    RunOptions options = run_options(shared_, row.settings);
    options.output_directory = (std::filesystem::path(shared_.output_directory) / row.folder).string();
    options.quiet = false;  // into its log
    const std::string name = fmt::format("run {} of {}  {}", begun_, count_, to_text(row.settings));
    if (resume_ && is_done(options)) {
        row.outcome = read_outcome(options.output_directory);
        say(name + "  done before", "\n");
        return;
    }
    if (terminal_) say(name + " ...", "\r");
    const auto start = std::chrono::steady_clock::now();
    perform(options, row);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    interrupted_ = row.outcome.exit_code == Interrupted;
    const std::string why = row.outcome.message.empty() ? "" : ": " + row.outcome.message;
    say(fmt::format("{}  {} in {:.1f} s{}", name, row.outcome.status, seconds, why), "\n");
}

}  // namespace stria::study
