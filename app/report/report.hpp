// `stria report`, and the report at the end of a run.
#pragma once

#include <filesystem>
#include <functional>

#include "app/run/run_options.hpp"

namespace stria::report {

/// Writes report.html into the folder of a run, which need not have ended. Throws CaseError where it holds no run, and
/// FileFailure where the page cannot be written.
void write_report(const std::filesystem::path& folder);

/// Runs `run` and writes the report whatever comes of it, unless the options say no: exit codes and exceptions pass
/// through. A page that cannot be written is a line on the terminal, not the end of a run that is done.
int with_report(const RunOptions& options, const std::function<int()>& run);

}  // namespace stria::report
