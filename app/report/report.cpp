#include "app/report/report.hpp"

#include <exception>
#include <fmt/format.h>

#include "app/process/exit_code.hpp"
#include "app/report/report_page.hpp"
#include "coarse/results/result_files.hpp"
#include "common/error.hpp"
#include "common/io/whole_file.hpp"

namespace stria::report {

namespace {

constexpr const char* page_name = coarse::result_files::report;

void try_report(const RunOptions& options) {
    const std::filesystem::path folder = options.output_directory;
    // Without a table nothing was run; why, whoever ran it says.
    if (!options.report || !std::filesystem::exists(folder / coarse::result_files::history)) return;
    try {
        write_report(folder);
        if (!options.quiet) fmt::print("page in {}/{}\n", options.output_directory, page_name);
    } catch (const std::exception& problem) {
        fmt::print(stderr, "warning: no {}: {}\n", page_name, problem.what());
    }
}

}  // namespace

void write_report(const std::filesystem::path& folder) {
    write_whole_text(folder / page_name, page_of(read_run(folder)));
}

int with_report(const RunOptions& options, const std::function<int()>& run) {
    int code = Done;
    try {
        code = run();
    } catch (const CaseError&) {
        throw;  // nothing was run
    } catch (...) {
        try_report(options);
        throw;
    }
    if (code != InputWrong) try_report(options);
    return code;
}

}  // namespace stria::report
