// The names of the files that a run leaves in its folder, and what becomes of those of an earlier run.
#pragma once

#include <array>
#include <filesystem>

namespace stria::coarse {

namespace result_files {

inline constexpr const char *resolved_case = "case.resolved.toml", *summary = "summary.json";
inline constexpr const char *history = "history.csv", *cycles = "cycles.csv", *faces = "faces.csv";
inline constexpr const char* closure = "closure.csv";        // where a profile of opening loads is asked for
inline constexpr const char* loads = "loads.csv";            // where there are load cases or pressures that travel
inline constexpr const char* load_cases = "load-cases.csv";  // where there are load cases
inline constexpr const char* checkpoint = "checkpoint.h5";
inline constexpr const char* report = "report.html";  // written by the program at the end, unless told not to

/// All of them but the checkpoint before the last one, and the fields, of which FieldWriter knows.
inline constexpr std::array all = {resolved_case, summary, history,    cycles,     faces,
                                   closure,       loads,   load_cases, checkpoint, report};

}  // namespace result_files

/// Beside `path`: the checkpoint before the last one.
std::filesystem::path previous_checkpoint(std::filesystem::path path);

/// The folder holds a checkpoint, the last one or the one before it.
[[nodiscard]] bool has_checkpoint(const std::filesystem::path& folder);

/// The folder holds the tables or the summary of a run.
[[nodiscard]] bool has_results(const std::filesystem::path& folder);

/// Before a run begins anew: no file of an earlier one must be taken for what this one has done.
void remove_results(const std::filesystem::path& folder);

}  // namespace stria::coarse
