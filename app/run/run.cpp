#include "app/run/run.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <memory>
#include <unistd.h>

#include "app/process/exit_code.hpp"
#include "app/process/interruption.hpp"
#include "app/run/coarse_run.hpp"
#include "app/run/fine_side.hpp"
#include "app/run/monolithic/monolithic.hpp"
#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "common/linear/sparse_lu.hpp"
#include "common/memory.hpp"
#include "coupling/transport/mpi_transport.hpp"
#include "coupling/transport/serve.hpp"
#include "fine/zone/fine_model.hpp"

namespace stria {
namespace {

/// mpirun puts a pipe or a terminal of its own between us and the user: the launcher knows what the user has.
bool users_terminal() { return std::getenv("STRIA_TERMINAL") != nullptr; }

/// Of a case without a fine component: mpirun wants every program to start MPI and to end it.
void meet_and_part(coupling::Role role) {
    if (coupling::under_mpirun()) const coupling::MpiSession session(role, coupling::Cast::Any);
}

/// Inside a catch block: says why, and ends all ranks.
[[noreturn]] void abort(const coupling::MpiSession& session, const char* program) {
    const Ending ending = ending_of_exception();
    fmt::print(stderr, "{}: {}\n", program, ending.text);
    std::fflush(stderr);
    session.abort(ending.code);
}

}  // namespace

int run_coarse_with_mpi(const RunOptions& options) {
    heed_interruption();
    use_one_thread();
    keep_freed_memory();
    const Case input = read_case(options.case_path, options.overrides);
    if (!needs_fine(input)) {
        meet_and_part(coupling::Role::Coarse);
        coarse::CondensedFactory alone(nullptr, input);
        return CoarseRun(options, input, {"mpi", 1, users_terminal()}).perform(alone, nullptr);
    }
    const coupling::MpiSession session(coupling::Role::Coarse);
    try {
        FineSide fine(input, session);
        coarse::CondensedFactory factory(&fine.scale(), input);
        return CoarseRun(options, input, {"mpi", 1 + session.peers(), users_terminal()}).perform(factory, &fine);
    } catch (const CaseError&) {
        throw;  // the conversation has ended in order: both sides leave
    } catch (const NumericalFailure&) {
        throw;
    } catch (...) {
        abort(session, "stria-coarse");
    }
}

int run_fine_with_mpi(const RunOptions& options) {
    ignore_interruption();
    use_one_thread();
    keep_freed_memory();
    const Case input = read_case(options.case_path, options.overrides);
    if (!needs_fine(input)) {
        meet_and_part(coupling::Role::Fine);
        return Done;
    }
    const coupling::MpiSession session(coupling::Role::Fine);
    try {
        const std::unique_ptr<coupling::Transport> transport = session.transport();
        fine::FineModel model(input);
        coupling::serve(*transport, model, digest(input));
    } catch (const CaseError&) {
        throw;
    } catch (...) {
        abort(session, "stria-fine");
    }
    return 0;
}

int run_in_process(const RunOptions& options) {
    heed_interruption();
    use_one_thread();
    keep_freed_memory();
    const Case input = read_case(options.case_path, options.overrides);
    CoarseRun run(options, input, {options.mode, 1, isatty(STDOUT_FILENO) != 0});
    if (!needs_fine(input)) {
        coarse::CondensedFactory alone(nullptr, input);
        return run.perform(alone, nullptr);
    }
    if (options.mode == "monolithic") {
        MonolithicFactory factory(input);
        return run.perform(factory, nullptr);
    }
    FineSide fine(input, options.fine_ranks);
    coarse::CondensedFactory factory(&fine.scale(), input);
    return run.perform(factory, &fine);
}

}  // namespace stria
