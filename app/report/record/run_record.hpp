// What a run has left in its folder, as far as a report needs it: of a finished run or of one that goes on or broke
// off.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/results/run_files.hpp"
#include "app/results/run_tables.hpp"
#include "coarse/results/run_status.hpp"
#include "common/case/case.hpp"
#include "common/io/number_table.hpp"

namespace stria::report {

struct RunRecord {
    std::filesystem::path folder;
    std::string resolved;       // text of case.resolved.toml
    std::optional<Case> input;  // what it says, where this version understands it
    JsonObject summary;         // empty as long as the run has not ended
    NumberTable history, cycles;
    NumberTable load_cases;  // empty without any

    [[nodiscard]] std::string title() const;
    /// Nothing as long as the run has not ended.
    [[nodiscard]] std::optional<coarse::RunStatus> status() const;
    /// At least 1: rows of a scene without tips count as those of tip 0.
    [[nodiscard]] std::size_t tips() const;
};

/// Throws CaseError where the folder holds no run.
RunRecord read_run(const std::filesystem::path& folder);

}  // namespace stria::report
