// How a program of ours ends: one line on standard error and the exit code that belongs to the failure.
#pragma once

#include <functional>
#include <string>

namespace stria {

/// Interrupted: by a signal, with a checkpoint written.
enum ExitCode { Done = 0, InternalError = 1, InputWrong = 2, NumbersFailed = 3, LostComponent = 4, Interrupted = 130 };

/// Runs the work and turns what it throws into an exit code. Where MPI is up it is aborted with that code: the other
/// component may be waiting for a message that will never come.
int exit_code_of(const std::string& program, const std::function<int()>& work);

}  // namespace stria
