// How our programs end: one line on standard error, and the exit code of the failure.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace stria {

/// The README says what each means. Defect: of this program (EX_SOFTWARE of sysexits.h).
enum ExitCode {
    Done = 0,
    InputWrong = 2,
    NumbersFailed = 3,
    LostComponent = 4,
    FileFailed = 5,
    Defect = 70,
    Interrupted = 130
};

/// As one line that a terminal shows as it is: what a damaged file has put into a message, control characters and bytes
/// that are no UTF-8, becomes "?".
std::string in_one_line(std::string_view text);

/// How a program ends that has thrown.
struct Ending {
    ExitCode code;
    std::string text;  // one line
};

/// Of what is being handled: inside a catch block.
Ending ending_of_exception();

/// Runs the work and turns what it throws into an exit code. Where MPI is running, it is aborted with that code: the
/// other component may wait for a message that will never come. From its call on, files that may grow no more are
/// errors of writing.
int exit_code_of(const std::string& program, const std::function<int()>& work);

}  // namespace stria
