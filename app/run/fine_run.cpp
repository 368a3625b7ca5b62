// By itself, so that stria-fine is linked without what the coarse component needs: HDF5 loads thirty libraries (curl
// and what it encrypts with), half of the time in which a program starts.
#include "app/process/exit_code.hpp"
#include "app/process/interruption.hpp"
#include "app/run/mpi_parting.hpp"
#include "app/run/run.hpp"
#include "common/case/case_questions.hpp"
#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"
#include "common/linear/blas.hpp"
#include "common/linear/huge_pages.hpp"
#include "common/memory.hpp"
#include "coupling/transport/serve.hpp"
#include "fine/zone/fine_model.hpp"

namespace stria {

int run_fine_with_mpi(const RunOptions& options) {
    ignore_interruption();
    use_one_thread();
    keep_freed_memory();
    use_huge_pages();
    const Case input = read_case(options.case_path, options.overrides);
    if (!needs_fine(input)) {
        meet_and_part(coupling::Role::Fine, input);
        return Done;
    }
    const coupling::MpiSession session(coupling::Role::Fine, digest(input));
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

}  // namespace stria
