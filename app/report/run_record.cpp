#include "app/report/run_record.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <limits>

#include "common/case/case_file.hpp"
#include "common/error.hpp"

namespace stria::report {

namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void require_columns(const NumberTable& table, const std::filesystem::path& path,
                     std::initializer_list<const char*> names) {
    if (table.columns.empty())
        throw CaseError(fmt::format("{} holds no run: there is no {} in it", path.parent_path().string(),
                                    path.filename().string()));
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

std::string RunRecord::status() const {
    const auto found = summary.words.find("status");
    return found != summary.words.end() ? found->second : "not ended";
}

std::size_t RunRecord::tips() const {
    double last = 0.0;
    if (history.columns.contains("tip"))
        for (const double tip : history["tip"]) last = std::fmax(last, tip);
    return static_cast<std::size_t>(last) + 1;
}

RunRecord read_run(const std::filesystem::path& folder) {
    RunRecord run;
    run.folder = folder;
    run.history = read_table(folder / "history.csv");
    require_columns(run.history, folder / "history.csv", {"increment", "cycle", "load_factor", "tip", "a"});
    run.cycles = read_table(folder / "cycles.csv");
    if (!run.cycles.columns.empty()) require_columns(run.cycles, folder / "cycles.csv", {"cycle", "tip"});
    run.load_cases = read_table(folder / "load-cases.csv");
    run.resolved = text_of(folder / "case.resolved.toml");
    run.input = read_back(folder / "case.resolved.toml");
    run.summary = read_json(folder / "summary.json");
    return run;
}

std::vector<std::size_t> rows_of_tip(const NumberTable& table, std::size_t tip) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const double number = table["tip"][row];
        if (std::isnan(number) ? tip == 0 : number == static_cast<double>(tip)) rows.push_back(row);
    }
    return rows;
}

std::vector<double> values_of(const NumberTable& table, const std::string& column,
                              const std::vector<std::size_t>& rows) {
    std::vector<double> values(rows.size(), std::numeric_limits<double>::quiet_NaN());
    if (!table.columns.contains(column)) return values;
    std::ranges::transform(rows, values.begin(), [&](std::size_t row) { return table[column][row]; });
    return values;
}

}  // namespace stria::report
