#include "app/process/children.hpp"

#include "app/process/exit_code.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace stria {

namespace {

/// A place is free where its process is 0.
struct Child {
    volatile std::sig_atomic_t process;
    volatile std::sig_atomic_t stands_apart;
};

std::array<Child, most_children> children = {};
volatile std::sig_atomic_t interruption = 0;

/// Who asks twice does not want to wait for the checkpoint that SIGUSR1 asks for.
void pass_on(int signal, bool again, const Child& child) {
    const auto process = static_cast<pid_t>(child.process);
    if (process <= 0) return;
    if (child.stands_apart != 0)
        kill(process, again ? SIGTERM : SIGUSR1);
    else if (signal == SIGTERM)
        kill(process, SIGTERM);
}

void note_signal(int signal) {
    const bool again = interruption != 0;
    interruption = signal;
    for (const Child& child : children) pass_on(signal, again, child);
}

/// While it lives SIGINT and SIGTERM wait.
class SignalsWait {
public:
    SignalsWait() {
        sigset_t ours;
        sigemptyset(&ours);
        sigaddset(&ours, SIGINT);
        sigaddset(&ours, SIGTERM);
        sigprocmask(SIG_BLOCK, &ours, &before_);
    }
    ~SignalsWait() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
    SignalsWait(const SignalsWait&) = delete;
    SignalsWait& operator=(const SignalsWait&) = delete;

    /// In the child: those that have come end it, for it does not hand them on.
    void end_in_child() const {
        for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
        sigprocmask(SIG_SETMASK, &before_, nullptr);
    }

private:
    sigset_t before_{};
};

void listen_for_signals() {
    struct sigaction action {};
    action.sa_handler = note_signal;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

/// In the child: out of reach of the terminal.
void stand_apart() {
    setpgid(0, 0);
    const int nothing = open("/dev/null", O_RDONLY);
    if (nothing < 0) return;
    dup2(nothing, STDIN_FILENO);
    close(nothing);
}

/// Output and errors of this process go to the file from here on.
void write_into(const char* log) {
    const int file = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file < 0) return;  // rather on the terminal than nowhere
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    close(file);
}

void run_on(const std::vector<int>& cores) {
    if (cores.empty()) return;
    cpu_set_t set;
    CPU_ZERO(&set);
    for (const int core : cores) CPU_SET(static_cast<std::size_t>(core), &set);
    sched_setaffinity(0, sizeof set, &set);  // a wish: without it the run is as right
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

Child& place_of(pid_t process) {
    const auto found = std::ranges::find_if(children, [&](const Child& child) { return child.process == process; });
    if (found == children.end()) throw std::runtime_error("too many child processes");
    return *found;
}

bool is_our_own(int code) {
    constexpr std::array ours{Done, InputWrong, NumbersFailed, LostComponent, FileFailed, Defect, Interrupted};
    return std::ranges::find(ours, code) != ours.end();
}

}  // namespace

pid_t start_child(const std::vector<std::string>& command, const ChildPlace& place) {
    std::fflush(nullptr);
    Child& child = place_of(0);
    listen_for_signals();
    const SignalsWait until_the_child_is_known;
    const pid_t process = fork();
    if (process < 0) throw std::runtime_error(fmt::format("fork: {}", std::strerror(errno)));
    if (process == 0) {
        until_the_child_is_known.end_in_child();
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        if (place.log.empty())
            stand_apart();
        else
            write_into(place.log.c_str());
        run_on(place.cores);
        become(command);
    }
    child.stands_apart = place.log.empty() ? 1 : 0;
    child.process = static_cast<std::sig_atomic_t>(process);
    if (interruption != 0) pass_on(interruption, false, child);  // it came before there was a child
    return process;
}

EndedChild wait_for_child() {
    int status = 0;
    pid_t process = 0;
    while ((process = waitpid(-1, &status, 0)) < 0)
        if (errno != EINTR) throw std::runtime_error(fmt::format("waitpid: {}", std::strerror(errno)));
    place_of(process).process = 0;
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (interruption != 0 && code != Done) return {process, Interrupted, true};
    return {process, code, is_our_own(code)};
}

bool asked_to_end() { return interruption != 0; }

std::vector<int> own_cores() {
    cpu_set_t set;
    CPU_ZERO(&set);
    std::vector<int> cores;
    if (sched_getaffinity(0, sizeof set, &set) != 0) return cores;  // more cores than the set holds
    for (int core = 0; core < CPU_SETSIZE; ++core)
        if (CPU_ISSET(static_cast<std::size_t>(core), &set)) cores.push_back(core);
    return cores;
}

std::vector<int> share_of(const std::vector<int>& cores, int part, int parts) {
    const int count = static_cast<int>(cores.size());
    if (count < parts) return cores;
    return {cores.begin() + part * count / parts, cores.begin() + (part + 1) * count / parts};
}

std::string quoted(const std::string& word) {
    const auto plain = [](char letter) {
        return std::isalnum(static_cast<unsigned char>(letter)) != 0 || std::strchr("_-./=,:+@%", letter) != nullptr;
    };
    if (!word.empty() && std::ranges::all_of(word, plain)) return word;
    std::string text = "'";
    for (const char letter : word) {
        if (letter == '\'') text += "'\\'";
        text += letter;
    }
    return text + "'";
}

std::string quoted(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty()) text += ' ';
        text += quoted(word);
    }
    return text;
}

}  // namespace stria
