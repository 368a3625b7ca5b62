#include "common/case/spectrum.hpp"

#include <cmath>
#include <fmt/format.h>

#include "common/error.hpp"
#include "common/io/number_table.hpp"

namespace stria {
namespace {

[[noreturn]] void reject(const std::filesystem::path& path, std::size_t row, const char* demand) {
    throw CaseError(fmt::format("{}:{}: load.spectrum: {}", path.string(), row + 2, demand));
}

/// The values at which a sequence turns, its ends included.
std::vector<double> turns(const std::vector<double>& values) {
    std::vector<double> turns;
    for (const double value : values) {
        if (!turns.empty() && value == turns.back()) continue;
        const std::size_t n = turns.size();
        const bool goes_on = n > 1 && (turns[n - 1] - turns[n - 2]) * (value - turns[n - 1]) > 0.0;
        if (goes_on)
            turns.back() = value;
        else
            turns.push_back(value);
    }
    return turns;
}

std::vector<LoadBlock> from_turning_points(const std::filesystem::path& path, const std::vector<double>& values) {
    for (std::size_t row = 0; row < values.size(); ++row)
        if (!std::isfinite(values[row])) reject(path, row, "must be a number");
    const std::vector<double> turning = turns(values);
    std::vector<LoadBlock> blocks;
    for (std::size_t k = 0; k + 1 < turning.size(); ++k)
        if (turning[k] > turning[k + 1]) blocks.push_back({.cycles = 1, .max = turning[k], .min = turning[k + 1]});
    return blocks;
}

std::vector<LoadBlock> from_cycles(const std::filesystem::path& path, const NumberTable& table) {
    std::vector<LoadBlock> blocks;
    const bool counted = table.columns.contains("cycles");
    for (std::size_t row = 0; row < table.rows; ++row) {
        const double max = table["max"][row], min = table["min"][row];
        const double cycles = counted ? table["cycles"][row] : 1.0;
        if (!std::isfinite(max) || !std::isfinite(min)) reject(path, row, "max and min must be numbers");
        if (min >= max) reject(path, row, "must keep min < max");
        if (!(cycles >= 1.0 && cycles <= 1e9 && cycles == std::floor(cycles)))
            reject(path, row, "cycles must be a whole number >= 1");
        blocks.push_back({.cycles = static_cast<int>(cycles), .max = max, .min = min});
    }
    return blocks;
}

/// Nothing that a table says is passed over.
void check_columns(const std::filesystem::path& path, const NumberTable& table) {
    const bool turning = table.columns.contains("turning_point");
    for (const auto& [name, values] : table.columns) {
        const bool known = turning ? name == "turning_point" : name == "max" || name == "min" || name == "cycles";
        if (!known)
            throw CaseError(fmt::format("{}:1: load.spectrum: column \"{}\" is not known, must be max, min and cycles, "
                                        "or turning_point alone",
                                        path.string(), name));
    }
}

}  // namespace

std::vector<LoadBlock> read_spectrum(const std::filesystem::path& path) {
    const NumberTable table = read_table(path);
    if (table.columns.empty()) throw CaseError(fmt::format("{}: load.spectrum: cannot be read", path.string()));
    if (table.cut_off) reject(path, table.rows, "has not as many cells as the line of names");
    check_columns(path, table);
    std::vector<LoadBlock> blocks;
    if (table.columns.contains("turning_point"))
        blocks = from_turning_points(path, table["turning_point"]);
    else if (table.columns.contains("max") && table.columns.contains("min"))
        blocks = from_cycles(path, table);
    else
        throw CaseError(
            fmt::format("{}:1: load.spectrum: must name columns max and min, or turning_point", path.string()));
    if (blocks.empty()) throw CaseError(fmt::format("{}: load.spectrum: holds no cycle", path.string()));
    return blocks;
}

}  // namespace stria
