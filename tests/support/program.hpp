// One of our programs as a child process: its exit code, what it says, and a hard limit on its time.
#pragma once

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "tests/support/folders.hpp"

namespace stria::test {

using Words = std::vector<std::string>;

inline std::string own_program(const std::string& name) { return std::string(program_folder) + "/" + name; }

class Program {
public:
    /// Starts a program of this build, or else one of the system; output and errors go to a file.
    Program(const std::string& name, Words arguments, std::string log) : log_(std::move(log)) {
        const std::string own = own_program(name);
        arguments.insert(arguments.begin(), std::filesystem::exists(own) ? own : name);
        std::vector<char*> words;
        for (std::string& word : arguments) words.push_back(word.data());
        words.push_back(nullptr);
        pid_ = fork();
        if (pid_ != 0) return;
        setpgid(0, 0);  // its children end with it
        const int file = open(log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
        execvp(words.front(), words.data());
        _exit(127);
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program() {
        if (!ended_) end_by_force();
    }

    /// Its exit code; -1 where it did not end in time (and is ended by force).
    int wait(std::chrono::seconds limit) {
        const auto end = std::chrono::steady_clock::now() + limit;
        int status = 0;
        while (waitpid(pid_, &status, WNOHANG) == 0) {
            if (std::chrono::steady_clock::now() > end) {
                end_by_force();
                return -1;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        ended_ = true;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

    [[nodiscard]] pid_t pid() const { return pid_; }
    [[nodiscard]] std::string said() const {
        std::ifstream file(log_);
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    }

private:
    void end_by_force() {
        kill(-pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
        ended_ = true;
    }

    std::string log_;
    pid_t pid_ = -1;
    bool ended_ = false;
};

/// Processes below `ancestor` that run the program `name`.
inline std::vector<pid_t> descendants(pid_t ancestor, const std::string& name) {
    std::vector<pid_t> found, open{ancestor};
    while (!open.empty()) {
        const std::string parent = std::to_string(open.back());
        open.pop_back();
        std::ifstream children("/proc/" + parent + "/task/" + parent + "/children");
        for (pid_t child = 0; children >> child;) {
            open.push_back(child);
            std::error_code gone;
            const auto program = std::filesystem::read_symlink("/proc/" + std::to_string(child) + "/exe", gone);
            if (program.filename() == name) found.push_back(child);
        }
    }
    return found;
}

/// Runs a program to its end; throws nothing, says nothing.
inline int run_program(const std::string& name, Words arguments, const std::string& log) {
    return Program(name, std::move(arguments), log).wait(std::chrono::seconds(120));
}

}  // namespace stria::test
