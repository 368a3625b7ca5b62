#include "app/run/launch.hpp"

#include "app/process/exit_code.hpp"
#include "app/run/fine_side.hpp"
#include "app/run/run_files.hpp"
#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "common/io/file_failure.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace stria {

namespace {

/// Two components share few cores: waiting ranks yield, nobody is bound, every rank is one thread, messages go
/// through shared memory. What the user has set stays.
constexpr std::array<std::pair<const char*, const char*>, 10> environment = {{
    {"OMPI_ALLOW_RUN_AS_ROOT", "1"},
    {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"},
    {"OMPI_MCA_mpi_yield_when_idle", "1"},
    {"OMPI_MCA_rmaps_base_oversubscribe", "1"},
    {"OMPI_MCA_hwloc_base_binding_policy", "none"},
    {"OMPI_MCA_btl", "self,vader"},
    {"OMPI_MCA_pml", "ob1"},
    {"OPENBLAS_NUM_THREADS", "1"},
    {"OMP_NUM_THREADS", "1"},
    {"OMP_THREAD_LIMIT", "1"},
}};

volatile std::sig_atomic_t interruption = 0;
volatile std::sig_atomic_t child = 0, child_stands_apart = 0;

/// mpirun would answer SIGINT and SIGTERM by killing the components: it stands apart from our terminal and is sent what
/// it passes on to them, SIGUSR1, on which they write a checkpoint; who asks twice does not want to wait for that. To
/// another child the terminal has sent its SIGINT already.
void note_signal(int signal) {
    const bool again = interruption != 0;
    interruption = signal;
    if (child <= 0) return;
    if (child_stands_apart != 0)
        kill(static_cast<pid_t>(child), again ? SIGTERM : SIGUSR1);
    else if (signal == SIGTERM)
        kill(static_cast<pid_t>(child), SIGTERM);
}

/// In the child: out of reach of the terminal, and gone when we are.
void stand_apart() {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    const int nothing = open("/dev/null", O_RDONLY);
    if (nothing < 0) return;
    dup2(nothing, STDIN_FILENO);
    close(nothing);
}

void listen_for_signals() {
    struct sigaction action {};
    action.sa_handler = note_signal;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

void append_common_options(const RunOptions& options, std::vector<std::string>& command) {
    command.insert(command.end(), {options.case_path, "-o", options.output_directory});
    for (const std::string& value : options.overrides) command.insert(command.end(), {"--set", value});
    if (options.resume)
        command.emplace_back("--resume");
    else if (options.force)
        command.emplace_back("--force");
    if (options.quiet) command.emplace_back("--quiet");
    if (options.verbose) command.emplace_back("--verbose");
}

std::vector<std::string> component_command(const RunOptions& options, const std::string& program) {
    std::vector<std::string> command = {program};
    append_common_options(options, command);
    command.emplace_back("--no-report");  // who starts the components writes it, whatever becomes of them
    return command;
}

[[noreturn]] void become(const std::vector<std::string>& command) {
    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    // execvp takes its words by pointers to char and leaves them alone.
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments.front(), arguments.data());
    fmt::print(stderr, "stria: {} cannot be started: {}\n", command.front(), std::strerror(errno));
    _exit(LostComponent);
}

/// Output and errors of this process go to the file from here on.
void write_into(const char* log) {
    const int file = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file < 0) return;  // rather on the terminal than nowhere
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    close(file);
}

/// Not one of mpirun, of the loader or of a signal.
bool is_our_own(int code) {
    constexpr std::array ours{Done, InputWrong, NumbersFailed, LostComponent, FileFailed, Defect, Interrupted};
    return std::ranges::find(ours, code) != ours.end();
}

int wait_for(pid_t process) {
    int status = 0;
    while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR) throw std::runtime_error(fmt::format("waitpid: {}", std::strerror(errno)));
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (interruption != 0 && code != Done) return Interrupted;
    if (is_our_own(code)) return code;
    throw ComponentLost(fmt::format("a component was lost (exit code {})", code));
}

/// `log`: null: it says what it says where we do, and stands apart.
pid_t start(const std::vector<std::string>& command, const char* log) {
    std::fflush(nullptr);
    child_stands_apart = log == nullptr ? 1 : 0;
    listen_for_signals();
    const pid_t process = fork();
    if (process < 0) throw std::runtime_error(fmt::format("fork: {}", std::strerror(errno)));
    if (process == 0) {
        if (log != nullptr)
            write_into(log);
        else
            stand_apart();
        become(command);
    }
    child = static_cast<std::sig_atomic_t>(process);
    return process;
}

/// Where this program and its components are.
std::string programs_folder() { return std::filesystem::read_symlink("/proc/self/exe").parent_path().string(); }

}  // namespace

void claim_output_directory(RunOptions& options) {
    if (options.output_directory.empty())
        options.output_directory = "runs/" + read_case(options.case_path, options.overrides).name;
    const std::filesystem::path folder = options.output_directory;
    std::error_code problem;
    const auto exists = [&](const char* result) { return std::filesystem::exists(folder / result, problem); };
    if (options.resume && !exists("checkpoint.h5") && !exists("checkpoint.previous.h5") &&
        read_json(folder / "summary.json").words["status"] == "done")
        throw CaseError(fmt::format("{} holds a run that left no checkpoint to go on from", folder.string()));
    if (!options.force && !options.resume && (exists("summary.json") || exists("history.csv")))
        throw CaseError(fmt::format("{} holds results; --resume goes on from its checkpoint, --force overwrites them, "
                                    "-o DIR writes elsewhere",
                                    folder.string()));
    std::filesystem::create_directories(folder, problem);
    if (!std::filesystem::is_directory(folder, problem) || access(folder.c_str(), W_OK) != 0)
        throw FileFailure(fmt::format("{}: the folder of results cannot be made or written to", folder.string()));
}

std::vector<std::string> launch_command(const RunOptions& options, const std::string& programs, bool with_fine) {
    std::vector<std::string> coarse = component_command(options, programs + "/stria-coarse");
    if (!with_fine) return coarse;
    const std::vector<std::string> fine = component_command(options, programs + "/stria-fine");
    std::vector<std::string> command = {"mpirun", "--quiet", "-n", "1"};
    command.insert(command.end(), coarse.begin(), coarse.end());
    command.insert(command.end(), {":", "-n", std::to_string(options.fine_ranks)});
    command.insert(command.end(), fine.begin(), fine.end());
    return command;
}

int launch(const RunOptions& options) {
    const Case input = read_case(options.case_path, options.overrides);
    const bool with_fine = needs_fine(input);
    const std::vector<std::string> command = launch_command(options, programs_folder(), with_fine);
    if (options.verbose) fmt::print("{}\n", fmt::join(command, " "));
    for (const auto& [name, value] : environment) setenv(name, value, 0);
    // Under mpirun a component writes into a pipe and cannot see the terminal.
    if (isatty(STDOUT_FILENO) != 0) setenv("STRIA_TERMINAL", "1", 0);
    return wait_for(start(command, nullptr));
}

int launch_logged(const RunOptions& options, const std::string& log) {
    if (interruption != 0) return Interrupted;
    std::vector<std::string> command = {programs_folder() + "/stria", "run"};
    append_common_options(options, command);
    command.insert(command.end(), {"--mode", options.mode, "--fine", std::to_string(options.fine_ranks)});
    if (!options.report) command.emplace_back("--no-report");
    try {
        return wait_for(start(command, log.c_str()));
    } catch (const ComponentLost&) {
        return LostComponent;
    }
}

}  // namespace stria
