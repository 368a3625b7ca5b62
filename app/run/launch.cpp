#include "app/run/launch.hpp"

#include "app/process/children.hpp"
#include "app/process/told_exit.hpp"
#include "app/process/writable_folder.hpp"
#include "app/results/run_files.hpp"
#include "app/run/run_lock.hpp"
#include "coarse/results/result_files.hpp"
#include "coarse/results/run_status.hpp"
#include "common/case/case_questions.hpp"
#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"
#include "common/io/file_failure.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>
#include <string_view>
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace stria {

namespace {

/// Two components share few cores: waiting ranks yield, nobody is bound, every rank is one thread, messages go
/// through shared memory. Nobody looks for graphics cards: MPI's map of the machine would load X11 and OpenCL for that
/// in every program (0.04 s). Nor for what else is plugged in: a virtual machine takes 0.01 s in each program to answer
/// for its cards. Two ranks need no shared store of each other's addresses (0.01 s). What the user has set stays.
constexpr std::array<std::pair<const char*, const char*>, 12> environment = {{
    {"OMPI_ALLOW_RUN_AS_ROOT", "1"},
    {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"},
    {"OMPI_MCA_mpi_yield_when_idle", "1"},
    {"OMPI_MCA_rmaps_base_oversubscribe", "1"},
    {"OMPI_MCA_hwloc_base_binding_policy", "none"},
    {"OMPI_MCA_pml", "ob1"},
    {"HWLOC_PLUGINS_PATH", "/nowhere"},
    {"HWLOC_COMPONENTS", "-linuxio"},
    {"PMIX_MCA_gds", "hash"},
    {"OPENBLAS_NUM_THREADS", "1"},
    {"OMP_NUM_THREADS", "1"},
    {"OMP_THREAD_LIMIT", "1"},
}};

void append_common_options(const RunOptions& options, std::vector<std::string>& command) {
    command.insert(command.end(), {options.case_path, "-o", options.output_directory});
    for (const std::string& value : options.overrides) command.insert(command.end(), {"--set", value});
    if (options.resume)
        command.emplace_back("--resume");
    else if (options.force)
        command.emplace_back("--force");
    if (options.max_seconds) command.insert(command.end(), {"--max-seconds", fmt::format("{}", *options.max_seconds)});
    if (options.quiet) command.emplace_back("--quiet");
    if (options.verbose) command.emplace_back("--verbose");
}

std::vector<std::string> component_command(const RunOptions& options, const std::string& program) {
    std::vector<std::string> command = {program};
    append_common_options(options, command);
    command.emplace_back("--no-report");  // who starts the components writes it, whatever becomes of them
    return command;
}

/// Of the folder, bytes that `processes` can write with a file each.
std::uint64_t room_in(const std::filesystem::path& folder, int processes) {
    struct statvfs state {};
    rlimit of_file{};
    if (statvfs(folder.c_str(), &state) != 0 || getrlimit(RLIMIT_FSIZE, &of_file) != 0) return 0;
    const std::uint64_t left = state.f_bavail * state.f_frsize, files = static_cast<std::uint64_t>(processes);
    return left / files < of_file.rlim_cur ? left : files * of_file.rlim_cur;
}

/// Through shared memory, or the loopback interface where there is too little of it: Open MPI itself would end without
/// a word, or, where there is no room for the bells of the components either, never.
void choose_way_of_messages(int processes) {
    const std::filesystem::path memory = "/dev/shm";
    const std::uint64_t room = room_in(memory, processes);
    const WayOfMessages way = way_of_messages(processes, room);
    if (way == WayOfMessages::None)
        throw FileFailure(fmt::format("{}: takes no more than {} bytes, too few for programs that talk to each other; "
                                      "--mode inprocess needs none",
                                      memory.string(), room));
    setenv("OMPI_MCA_btl", way == WayOfMessages::Memory ? "self,vader" : "self,tcp", 0);
    if (way == WayOfMessages::Loopback) setenv("OMPI_MCA_btl_tcp_if_include", "lo", 0);
}

/// The folder holds a run that has come to its end.
bool is_done(const std::filesystem::path& folder) {
    const JsonObject summary = read_json(folder / coarse::result_files::summary);
    return coarse::run_status(summary.word("status")) == coarse::RunStatus::Done;
}

/// Where this program and its components are.
std::string programs_folder() { return std::filesystem::read_symlink("/proc/self/exe").parent_path().string(); }

bool can_be_started(const std::filesystem::path& program) {
    std::error_code problem;
    return std::filesystem::is_regular_file(program, problem) && access(program.c_str(), X_OK) == 0;
}

/// As a shell looks for it. An empty folder of the path is the present one.
bool is_on_path(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "/bin:/usr/bin");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (can_be_started(std::filesystem::path(folder) / name)) return true;
    return false;
}

/// Before anything is started: mpirun would say nothing, with its --quiet, of a program that is not there.
void require_programs(const std::string& programs, bool with_fine) {
    for (const char* name : {"stria-coarse", "stria-fine"})
        if ((with_fine || name == std::string_view("stria-coarse")) && !can_be_started(programs + "/" + name))
            throw FileFailure(fmt::format("{}/{}: there is no such program; stria starts those beside it, --mode "
                                          "inprocess needs none",
                                          programs, name));
    if (with_fine && !is_on_path("mpirun"))
        throw FileFailure("mpirun: there is no such program on PATH; --mode inprocess needs none");
}

}  // namespace

void claim_output_directory(RunOptions& options) {
    if (options.output_directory.empty())
        options.output_directory = "runs/" + read_case(options.case_path, options.overrides).name;
    const std::filesystem::path folder = options.output_directory;
    if (options.resume && !coarse::has_checkpoint(folder) && is_done(folder))
        throw CaseError(fmt::format("{} holds a run that left no checkpoint to go on from", folder.string()));
    if (!options.force && !options.resume && coarse::has_results(folder))
        throw CaseError(fmt::format("{} holds results; --resume goes on from its checkpoint, --force overwrites them, "
                                    "-o DIR writes elsewhere",
                                    folder.string()));
    if (!options.force && holds_study(folder))
        throw CaseError(fmt::format("{} holds a study, and the tables of a run are no part of it; -o DIR writes "
                                    "elsewhere, --force takes its table and page away",
                                    folder.string()));
    if (holds_study(folder)) {  // who reads the folder would take the run for a study
        const RunLock lock(folder);
        remove_study(folder);
    }
    make_writable_folder(folder);
}

RunParts parts_of(const RunOptions& options, bool with_fine) {
    if (!with_fine || options.mode == RunMode::Monolithic) return {};
    return {options.fine_ranks, options.mode == RunMode::Mpi ? std::max(2, options.fine_ranks) : 1};
}

WayOfMessages way_of_messages(int processes, std::uint64_t room) {
    constexpr std::uint64_t segment = 5 << 20, bells = 8 << 10;  // per process; Open MPI's own segment has 4 MiB
    const auto count = static_cast<std::uint64_t>(processes);
    if (room >= count * segment) return WayOfMessages::Memory;
    return room >= count * bells ? WayOfMessages::Loopback : WayOfMessages::None;
}

std::vector<std::string> launch_command(const RunOptions& options, const std::string& programs, bool with_fine) {
    std::vector<std::string> coarse = component_command(options, programs + "/stria-coarse");
    if (!with_fine) return coarse;
    const std::vector<std::string> fine = component_command(options, programs + "/stria-fine");
    // The structure waits while the zone works: of several ranks one lives with it, and no core is asked for in vain.
    const auto [fine_ranks, processes] = parts_of(options, with_fine);
    if (fine_ranks == processes) coarse.emplace_back("--own-rank");
    std::vector<std::string> command = {"mpirun", "--quiet", "-n", "1"};
    command.insert(command.end(), coarse.begin(), coarse.end());
    command.insert(command.end(), {":", "-n", std::to_string(processes - 1)});
    command.insert(command.end(), fine.begin(), fine.end());
    return command;
}

int launch(const RunOptions& options) {
    const Case input = read_case(options.case_path, options.overrides);
    const bool with_fine = needs_fine(input);
    const std::string programs = programs_folder();
    require_programs(programs, with_fine);
    const std::vector<std::string> command = launch_command(options, programs, with_fine);
    if (options.verbose) fmt::print("{}\n", fmt::join(command, " "));
    for (const auto& [name, value] : environment) setenv(name, value, 0);
    if (with_fine) choose_way_of_messages(parts_of(options, with_fine).processes);
    // Under mpirun a component writes into a pipe and cannot see the terminal.
    if (isatty(STDOUT_FILENO) != 0) setenv("STRIA_TERMINAL", "1", 0);
    const ToldExit told;
    start_child(command, {});
    const EndedChild ended = wait_for_child();
    if (ended.ours) return told.code_or(ended.code);
    // Components that lose mpirun notice it after a second or two, and write until then: who resumes finds the folder
    // free.
    wait_until_free(options.output_directory, std::chrono::seconds(10));
    throw ComponentLost(fmt::format("a component was lost (exit code {})", ended.code));
}

std::vector<std::string> run_command(const RunOptions& options) {
    std::vector<std::string> command = {programs_folder() + "/stria", "run"};
    append_common_options(options, command);
    command.insert(command.end(), {"--mode", to_text(options.mode), "--fine", std::to_string(options.fine_ranks)});
    if (!options.report) command.emplace_back("--no-report");
    return command;
}

}  // namespace stria
