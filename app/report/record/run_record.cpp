#include "app/report/record/run_record.hpp"

#include <cmath>
#include <fmt/format.h>

#include "coarse/results/result_files.hpp"
#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"

namespace stria::report {

namespace result_files = coarse::result_files;

namespace {

void require_columns(const NumberTable& table, const std::filesystem::path& path,
                     std::initializer_list<const char*> names) {
    const std::filesystem::path folder = path.parent_path();
    if (table.columns.empty() && holds_study(folder))
        throw CaseError(fmt::format("{} holds a study: its page is study.html, and each of its runs has a folder there",
                                    folder.string()));
    if (table.columns.empty())
        throw CaseError(
            fmt::format("{} holds no run: there is no {} in it", folder.string(), path.filename().string()));
    for (const char* name : names)
        if (!table.columns.contains(name))
            throw CaseError(fmt::format("{} is no table of a run: it has no column {}", path.string(), name));
}

/// An older version may have written it, or its spectrum may lie elsewhere: a report can do without.
std::optional<Case> read_back(const std::filesystem::path& path) {
    try {
        return read_case(path.string(), {});
    } catch (const CaseError&) {
        return std::nullopt;
    }
}

}  // namespace

std::string RunRecord::title() const {
    if (input && !input->title.empty()) return input->title;
    return std::filesystem::weakly_canonical(folder).filename().string();
}

std::optional<coarse::RunStatus> RunRecord::status() const { return coarse::run_status(summary.word("status")); }

std::size_t RunRecord::tips() const {
    double last = 0.0;
    if (history.columns.contains("tip"))
        for (const double tip : history["tip"]) last = std::fmax(last, tip);
    return static_cast<std::size_t>(last) + 1;
}

RunRecord read_run(const std::filesystem::path& folder) {
    RunRecord run;
    run.folder = folder;
    run.history = read_table(folder / result_files::history);
    require_columns(run.history, folder / result_files::history, {"increment", "cycle", "load_factor", "tip", "a"});
    run.cycles = read_table(folder / result_files::cycles);
    if (!run.cycles.columns.empty()) require_columns(run.cycles, folder / result_files::cycles, {"cycle", "tip"});
    run.load_cases = read_table(folder / result_files::load_cases);
    run.resolved = read_text(folder / result_files::resolved_case);
    run.input = read_back(folder / result_files::resolved_case);
    run.summary = read_json(folder / result_files::summary);
    return run;
}

}  // namespace stria::report
