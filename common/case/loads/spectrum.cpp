#include "common/case/loads/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "common/error.hpp"
#include "common/io/number_table.hpp"

namespace stria {
namespace {

[[noreturn]] void reject(const std::filesystem::path& path, const NumberTable& table, std::size_t row,
                         const std::string& demand) {
    throw CaseError(fmt::format("{}:{}: load.spectrum: {}", path.string(), table.lines[row], demand));
}

/// The rows at which a sequence turns, its ends included; of equal values in a row the first.
std::vector<std::size_t> turns(const std::vector<double>& values) {
    std::vector<std::size_t> turns;
    for (std::size_t row = 0; row < values.size(); ++row) {
        if (!turns.empty() && values[row] == values[turns.back()]) continue;
        const std::size_t n = turns.size();
        const bool goes_on =
            n > 1 && (values[turns[n - 1]] - values[turns[n - 2]]) * (values[row] - values[turns[n - 1]]) > 0.0;
        if (goes_on)
            turns.back() = row;
        else
            turns.push_back(row);
    }
    return turns;
}

/// Of a sequence that is gone through again and again: what comes before its first maximum follows its last point.
void close(std::vector<std::size_t>& turning, const std::vector<double>& values) {
    if (turning.size() < 3) return;
    const auto value = [&](std::size_t k) { return values[turning[k]]; };
    const std::size_t last = turning.size() - 1;
    const bool begins_with_maximum = value(0) > value(1), ends_with_maximum = value(last) > value(last - 1);
    if (begins_with_maximum && ends_with_maximum) {  // one turn, with nothing between them
        if (value(last) > value(0)) turning.front() = turning.back();
        turning.pop_back();
    } else if (!begins_with_maximum && ends_with_maximum) {
        turning.push_back(turning.front());
    } else if (!begins_with_maximum && value(0) < value(last)) {
        turning.back() = turning.front();
    }
}

/// The main history alone says where the load turns.
void require_straight(const std::filesystem::path& path, const NumberTable& table, const std::string& name,
                      const std::vector<std::size_t>& turning) {
    const std::vector<double>&main = table["turning_point"], &own = table[name];
    double largest = 0.0;
    for (const double value : own) largest = std::max(largest, std::abs(value));
    for (std::size_t k = 0; k + 1 < turning.size(); ++k) {
        const std::size_t from = turning[k], to = turning[k + 1];
        for (std::size_t row = from; row <= to; ++row) {
            const double way = (main[row] - main[from]) / (main[to] - main[from]);
            if (std::abs(own[row] - std::lerp(own[from], own[to], way)) <= 1e-9 * largest) continue;
            reject(path, table, row,
                   fmt::format("column \"{}\" leaves the straight line between two turns of turning_point", name));
        }
    }
}

Spectrum from_turning_points(const std::filesystem::path& path, const NumberTable& table,
                             const std::vector<std::string>& cases, bool repeats) {
    for (const auto& [name, values] : table.columns)
        for (std::size_t row = 0; row < values.size(); ++row)
            if (!std::isfinite(values[row])) reject(path, table, row, "must be a number");
    const std::vector<double>& main = table["turning_point"];
    std::vector<std::size_t> turning = turns(main);
    for (const std::string& name : cases) require_straight(path, table, name, turning);
    if (repeats) close(turning, main);
    Spectrum spectrum;
    spectrum.cases.resize(cases.size());
    for (std::size_t k = 0; k + 1 < turning.size(); ++k) {
        const std::size_t max = turning[k], min = turning[k + 1];
        if (main[max] <= main[min]) continue;
        spectrum.blocks.push_back({.cycles = 1, .max = main[max], .min = main[min]});
        for (std::size_t c = 0; c < cases.size(); ++c)
            spectrum.cases[c].push_back({1, table[cases[c]][max], table[cases[c]][min]});
    }
    return spectrum;
}

std::vector<LoadBlock> from_cycles(const std::filesystem::path& path, const NumberTable& table) {
    std::vector<LoadBlock> blocks;
    const bool counted = table.columns.contains("cycles");
    for (std::size_t row = 0; row < table.rows; ++row) {
        const double max = table["max"][row], min = table["min"][row];
        const double cycles = counted ? table["cycles"][row] : 1.0;
        if (!std::isfinite(max) || !std::isfinite(min)) reject(path, table, row, "max and min must be numbers");
        if (min >= max) reject(path, table, row, "must keep min < max");
        if (!(cycles >= 1.0 && cycles <= 1e9 && cycles == std::floor(cycles)))
            reject(path, table, row,
                   "cycles must be a whole number >= 1; half cycles of a count go into a list of turning points");
        blocks.push_back({.cycles = static_cast<int>(cycles), .max = max, .min = min});
    }
    return blocks;
}

/// Of a first line that is not the names of columns with commas between them.
std::string how_to_write(const std::string& name) {
    if (name.find_first_of(";\t") != std::string::npos) return "; commas stand between cells, and points in numbers";
    const bool is_number = !name.empty() && name.find_first_not_of("0123456789+-.eE") == std::string::npos;
    return is_number || name.starts_with('#') ? "; the first line holds the names" : "";
}

/// Nothing that a table says is passed over.
void check_columns(const std::filesystem::path& path, const NumberTable& table, const std::vector<std::string>& cases) {
    if (!table.repeated.empty())
        throw CaseError(fmt::format("{}:{}: load.spectrum: column \"{}\" is given twice", path.string(),
                                    table.names_line, table.repeated));
    const bool turning = table.columns.contains("turning_point");
    const auto is_case = [&](const std::string& name) { return std::ranges::find(cases, name) != cases.end(); };
    for (const auto& [name, values] : table.columns) {
        const bool known =
            turning ? name == "turning_point" || is_case(name) : name == "max" || name == "min" || name == "cycles";
        if (!known)
            throw CaseError(fmt::format(
                "{}:{}: load.spectrum: column \"{}\" is not known, must be max, min and cycles, "
                "or turning_point alone{}{}",
                path.string(), table.names_line, name,
                cases.empty() ? "" : " with the load cases that have no other history", how_to_write(name)));
    }
    for (const std::string& name : cases)
        if (!table.columns.contains(name))
            throw CaseError(fmt::format("{}:{}: load.spectrum: the load case \"{}\" has no history: it needs a column "
                                        "of its name beside turning_point, or constant, factor or blocks",
                                        path.string(), table.names_line, name));
}

}  // namespace

Spectrum read_spectrum(const std::filesystem::path& path, const std::vector<std::string>& cases, bool repeats) {
    const NumberTable table = read_table(path);
    if (table.columns.empty()) throw CaseError(fmt::format("{}: load.spectrum: cannot be read", path.string()));
    check_columns(path, table, cases);
    if (table.cut_off) reject(path, table, table.rows, "has not as many cells as the line of names");
    Spectrum spectrum;
    if (table.columns.contains("turning_point"))
        spectrum = from_turning_points(path, table, cases, repeats);
    else if (table.columns.contains("max") && table.columns.contains("min"))
        spectrum.blocks = from_cycles(path, table);
    else
        throw CaseError(fmt::format("{}:{}: load.spectrum: must name columns max and min, or turning_point",
                                    path.string(), table.names_line));
    if (spectrum.blocks.empty()) throw CaseError(fmt::format("{}: load.spectrum: holds no cycle", path.string()));
    return spectrum;
}

void take_spectrum(Case& whole, const std::filesystem::path& folder) {
    std::vector<LoadCaseSection*> without_history;
    std::vector<std::string> names;
    for (LoadCaseSection& load_case : whole.load_cases) {
        if (load_case.constant || load_case.factor || !load_case.blocks.empty()) continue;
        without_history.push_back(&load_case);
        names.push_back(load_case.name);
    }
    const std::filesystem::path file = folder / *whole.load.spectrum;
    const Spectrum spectrum = read_spectrum(file, names, whole.load.repeat > 1 && whole.load.blocks.empty());
    if (!names.empty() && !whole.load.blocks.empty())
        throw CaseError(
            fmt::format("{}: load.spectrum: the load case \"{}\" is a column of it and has no factor in the "
                        "cycles of load.blocks before: leave these out",
                        file.string(), names.front()));
    whole.load.blocks.insert(whole.load.blocks.end(), spectrum.blocks.begin(), spectrum.blocks.end());
    for (std::size_t c = 0; c < names.size(); ++c) without_history[c]->blocks = spectrum.cases[c];
    whole.load.spectrum.reset();  // the resolved case stands alone
}

}  // namespace stria
