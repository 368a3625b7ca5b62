// How the two components of a run leave MPI where they do not end in order.
#pragma once

#include <cstdio>
#include <fmt/format.h>

#include "app/process/exit_code.hpp"
#include "common/case/schema/case_file.hpp"
#include "coupling/transport/mpi_transport.hpp"

namespace stria {

/// Of a case without a fine component: mpirun wants every program to start MPI and to end it. Throws CaseError where
/// another one was given another case, which may need a fine component and would wait for it.
inline void meet_and_part(coupling::Role role, const Case& input) {
    if (coupling::under_mpirun()) const coupling::MpiSession session(role, digest(input), coupling::Cast::Any);
}

/// Inside a catch block: says why, and ends all ranks.
[[noreturn]] inline void abort(const coupling::MpiSession& session, const char* program) {
    const Ending ending = ending_of_exception();
    fmt::print(stderr, "{}: {}\n", program, ending.text);
    std::fflush(stderr);
    session.abort(ending.code);
}

}  // namespace stria
