// How the components of a run live together.
#pragma once

#include <string>
#include <string_view>

namespace stria {

/// Two programs that talk over MPI, both components in one program, or both in one matrix.
enum class RunMode { Mpi, InProcess, Monolithic };

/// As --mode and the summary say it: mpi, inprocess, monolithic.
std::string to_text(RunMode mode);

/// Throws CaseError where a word is none of these; it names the `option` that was given.
RunMode run_mode(std::string_view word, const std::string& option);

}  // namespace stria
