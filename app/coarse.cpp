// The program `stria-coarse`: the structure, its equilibrium and its results; the fine component is another process.
#include "app/command_line.hpp"
#include "app/process/exit_code.hpp"
#include "app/process/told_exit.hpp"
#include "app/report/report.hpp"
#include "app/run/launch.hpp"
#include "app/run/run.hpp"
#include "common/linear/blas.hpp"

int main(int argc, char** argv) {
    stria::begin_with_kernels_of_the_processor(argv);
    return stria::tell_exit(stria::exit_code_of("stria-coarse", [&]() -> int {
        std::optional<stria::Command> command = stria::parse_component("stria-coarse", argc, argv);
        if (!command) return stria::Done;
        stria::claim_output_directory(command->run);
        return stria::report::with_report(command->run, [&] { return stria::run_coarse_with_mpi(command->run); });
    }));
}
