#include "app/run/run.hpp"

#include <cstdlib>
#include <memory>
#include <unistd.h>

#include "app/process/interruption.hpp"
#include "app/run/coarse_run.hpp"
#include "app/run/fine_side.hpp"
#include "app/run/monolithic/monolithic.hpp"
#include "app/run/mpi_parting.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "common/case/case_questions.hpp"
#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"
#include "common/linear/blas.hpp"
#include "common/linear/huge_pages.hpp"
#include "common/memory.hpp"

namespace stria {
namespace {

/// mpirun puts a pipe or a terminal of its own between us and the user: the launcher knows what the user has.
bool users_terminal() { return std::getenv("STRIA_TERMINAL") != nullptr; }

void heed_interruption_of(const RunOptions& options) {
    heed_interruption();
    if (options.max_seconds) interrupt_after(*options.max_seconds);
}

}  // namespace

int run_coarse_with_mpi(const RunOptions& options) {
    heed_interruption_of(options);
    use_one_thread();
    keep_freed_memory();
    use_huge_pages();
    const Case input = read_case(options.case_path, options.overrides);
    if (!needs_fine(input)) {
        meet_and_part(coupling::Role::Coarse, input);
        if (coupling::under_mpirun()) interrupt_with_parent();  // MPI has ended: nothing else tells of mpirun's end
        coarse::CondensedFactory alone(nullptr, input);
        return CoarseRun(options, input, {RunMode::Mpi, 1, users_terminal()}).perform(alone, nullptr);
    }
    const coupling::MpiSession session(coupling::Role::Coarse, digest(input));
    try {
        FineSide fine(input, session, options.own_rank);
        coarse::CondensedFactory factory(&fine.scale(), input);
        return CoarseRun(options, input, {RunMode::Mpi, 1 + session.peers(), users_terminal()}).perform(factory, &fine);
    } catch (const CaseError&) {
        throw;  // the conversation has ended in order: both sides leave
    } catch (const NumericalFailure&) {
        throw;
    } catch (...) {
        abort(session, "stria-coarse");
    }
}

int run_in_process(const RunOptions& options) {
    heed_interruption_of(options);
    use_one_thread();
    keep_freed_memory();
    use_huge_pages();
    const Case input = read_case(options.case_path, options.overrides);
    CoarseRun run(options, input, {options.mode, 1, isatty(STDOUT_FILENO) != 0});
    if (!needs_fine(input)) {
        coarse::CondensedFactory alone(nullptr, input);
        return run.perform(alone, nullptr);
    }
    if (options.mode == RunMode::Monolithic) {
        MonolithicFactory factory(input);
        return run.perform(factory, nullptr);
    }
    FineSide fine(input, options.fine_ranks);
    coarse::CondensedFactory factory(&fine.scale(), input);
    return run.perform(factory, &fine);
}

}  // namespace stria
