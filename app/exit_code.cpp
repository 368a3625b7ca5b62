#include "app/exit_code.hpp"

#include "common/error.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <mpi.h>
#include <string_view>

namespace stria {

namespace {

bool mpi_is_up() {
    int initialized = 0;
    int finalized = 0;
    MPI_Initialized(&initialized);
    MPI_Finalized(&finalized);
    return initialized != 0 && finalized == 0;
}

/// Both components read the case: where mpirun started them together, the coarse one alone complains about it.
bool coarse_complains_too(const std::string& program) {
    const char* size = std::getenv("OMPI_COMM_WORLD_SIZE");
    return program == "stria-fine" && size != nullptr && std::string_view(size) != "1";
}

int leave(const std::string& program, const char* what, int code) {
    if (code != InputWrong || !coarse_complains_too(program)) {
        fmt::print(stderr, "{}: {}\n", program, what);
        std::fflush(stderr);
    }
    if (mpi_is_up()) MPI_Abort(MPI_COMM_WORLD, code);
    return code;
}

}  // namespace

int exit_code_of(const std::string& program, const std::function<int()>& work) {
    try {
        return work();
    } catch (const CaseError& error) {
        return leave(program, error.what(), InputWrong);
    } catch (const NumericalFailure& error) {
        return leave(program, error.what(), NumbersFailed);
    } catch (const ComponentLost& error) {
        return leave(program, error.what(), LostComponent);
    } catch (const std::exception& error) {
        return leave(program, error.what(), InternalError);
    } catch (...) {
        return leave(program, "failed for an unknown reason", InternalError);
    }
}

}  // namespace stria
