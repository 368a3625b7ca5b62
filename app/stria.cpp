// The program `stria`: the commands a user types.
#include "app/command_line.hpp"
#include "app/material/material.hpp"
#include "app/process/exit_code.hpp"
#include "app/report/report.hpp"
#include "app/run/check.hpp"
#include "app/run/launch.hpp"
#include "app/run/run.hpp"
#include "app/study/study.hpp"
#include "common/case/schema/case_file.hpp"
#include "common/linear/blas.hpp"

#include <fmt/format.h>

namespace {

int run(stria::RunOptions options) {
    stria::claim_output_directory(options);
    return stria::report::with_report(options, [&] {
        if (options.mode != stria::RunMode::Mpi) return stria::run_in_process(options);
        options.force = true;  // the folder is ours now
        return stria::launch(options);
    });
}

int report(const stria::RunOptions& options) {
    stria::report::write_report(options.output_directory);
    if (!options.quiet) fmt::print("{}/report.html\n", options.output_directory);
    return stria::Done;
}

int explain(const stria::Command& command) {
    fmt::print("{}", command.markdown ? stria::case_reference_markdown() : stria::explain(command.key));
    return stria::Done;
}

int work(int argc, const char* const* argv) {
    const std::optional<stria::Command> command = stria::parse_stria(argc, argv);
    if (!command) return stria::Done;
    if (command->name == "check") return stria::check(command->run);
    if (command->name == "study") return stria::study::run_study(command->study);
    if (command->name == "report") return report(command->run);
    if (command->name == "material") return stria::material::test_material(command->run);
    if (command->name == "explain") return explain(*command);
    return run(command->run);
}

}  // namespace

int main(int argc, char** argv) {
    stria::begin_with_kernels_of_the_processor(argv);
    return stria::exit_code_of("stria", [&] { return work(argc, argv); });
}
