#include "common/io/number_table.hpp"

#include <charconv>
#include <fstream>
#include <limits>
#include <string_view>

#include "common/io/byte_order_mark.hpp"

namespace stria {
namespace {

std::string_view trimmed(std::string_view cell) {
    constexpr std::string_view blank = " \t\r";
    const std::size_t first = cell.find_first_not_of(blank);
    return first == std::string_view::npos ? "" : cell.substr(first, cell.find_last_not_of(blank) - first + 1);
}

/// What spreadsheets and text editors put around a cell, RFC 4180.
std::string_view without_quotes(std::string_view cell) {
    const bool quoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
    return quoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

std::vector<std::string_view> cells_of(std::string_view line) {
    std::vector<std::string_view> cells;
    for (std::size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(',')) {
        cells.push_back(without_quotes(trimmed(line.substr(0, comma))));
        line.remove_prefix(comma + 1);
    }
    cells.push_back(without_quotes(trimmed(line)));
    return cells;
}

double number_in(std::string_view cell) {
    if (cell.starts_with('+') && !cell.starts_with("+-")) cell.remove_prefix(1);
    double number = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    const bool whole = error == std::errc{} && end == cell.data() + cell.size();
    return whole ? number : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

NumberTable read_table(const std::filesystem::path& path) {
    return read_table(path, [](double) { return true; });
}

NumberTable read_table(const std::filesystem::path& path, const std::function<bool(double)>& wanted) {
    NumberTable table;
    std::ifstream file(path);
    std::string line;
    while (trimmed(line).empty()) {
        if (!std::getline(file, line)) return table;
        const bool first = ++table.names_line == 1;
        if (first && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    }
    std::vector<std::vector<double>*> columns;
    for (const std::string_view name : cells_of(line)) {
        if (table.repeated.empty() && table.columns.contains(std::string(name))) table.repeated = name;
        columns.push_back(&table.columns[std::string(name)]);
    }
    for (std::size_t number = table.names_line + 1; std::getline(file, line); ++number) {
        const std::string_view text = line;
        if (trimmed(text).empty() || !wanted(number_in(without_quotes(trimmed(text.substr(0, text.find(',')))))))
            continue;
        const std::vector<std::string_view> cells = cells_of(line);
        table.lines.push_back(number);
        table.cut_off = cells.size() != columns.size();
        if (table.cut_off) break;
        for (std::size_t k = 0; k < cells.size(); ++k) columns[k]->push_back(number_in(cells[k]));
        ++table.rows;
    }
    return table;
}

}  // namespace stria
