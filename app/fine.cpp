// The program `stria-fine`: serves plasticity and contact in the zones to a `stria-coarse` of the same mpirun.
#include "app/command_line.hpp"
#include "app/process/exit_code.hpp"
#include "app/run/run.hpp"
#include "common/linear/blas.hpp"

int main(int argc, char** argv) {
    stria::begin_with_kernels_of_the_processor(argv);
    return stria::exit_code_of("stria-fine", [&]() -> int {
        const std::optional<stria::Command> command = stria::parse_component("stria-fine", argc, argv);
        return command ? stria::run_fine_with_mpi(command->run) : stria::Done;
    });
}
