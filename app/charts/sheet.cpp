#include "app/charts/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdexcept>

#include "app/charts/drawing.hpp"
#include "app/results/run_tables.hpp"

namespace stria::charts {

namespace {

std::string cell_text(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

/// What has a meaning in an address, or cannot stand in one.
std::string in_address(const std::string& text) {
    std::string result;
    for (const char c : text) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                           std::string_view("-._~,:()/").find(c) != std::string_view::npos;
        result += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return result;
}

}  // namespace

Sheet sheet_of(const NumberTable& table, const std::string& name, const std::vector<std::size_t>& rows,
               const std::vector<std::string>& columns) {
    Sheet sheet{.name = name};
    for (const std::string& column : columns) sheet.columns.push_back({column, values_of(table, column, rows)});
    return sheet;
}

const std::vector<double>& Sheet::operator[](const std::string& column) const {
    const auto found = std::ranges::find(columns, column, &Column::name);
    if (found == columns.end()) throw std::out_of_range("no column " + column);
    return found->values;
}

std::string csv(const Sheet& sheet) {
    std::vector<std::string> cells;
    for (const Sheet::Column& column : sheet.columns) cells.push_back(column.name);
    std::string text = fmt::format("{}\n", fmt::join(cells, ","));
    const std::size_t rows = sheet.columns.empty() ? 0 : sheet.columns.front().values.size();
    for (std::size_t row = 0; row < rows; ++row) {
        cells.clear();
        for (const Sheet::Column& column : sheet.columns) cells.push_back(cell_text(column.values[row]));
        text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    return text;
}

std::string csv_link(const Sheet& sheet) {
    return fmt::format("<a class=\"csv\" download=\"{0}.csv\" href=\"data:text/csv;charset=utf-8,{1}\">{0}.csv</a>\n",
                       escaped(sheet.name), in_address(csv(sheet)));
}

Curve curve_of(const Sheet& sheet, const std::string& x, const std::string& y, const std::string& name) {
    return {.name = name.empty() ? y : name, .x = sheet[x], .y = sheet[y]};
}

}  // namespace stria::charts
