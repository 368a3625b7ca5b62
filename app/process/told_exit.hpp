// How a component that has left MPI in order tells its exit code to who started mpirun. mpirun takes two seconds more
// over any code but 0: it sends signals to programs that have gone, and waits a second after each.
#pragma once

#include <filesystem>

namespace stria {

/// Made by who starts mpirun, before it does: the place to tell the code is in the environment.
class ToldExit {
public:
    ToldExit();
    ~ToldExit();
    ToldExit(const ToldExit&) = delete;
    ToldExit& operator=(const ToldExit&) = delete;

    /// What was told, once mpirun has ended with `code`; else that code.
    [[nodiscard]] int code_or(int code) const;

private:
    std::filesystem::path file_;  // empty: there is no room for one, and nobody tells
};

/// What a component returns from main whose exit code is `code`: 0 where it could tell that.
int tell_exit(int code);

}  // namespace stria
