#include "app/results/run_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stria {

std::vector<std::size_t> rows_of_tip(const NumberTable& table, std::size_t tip) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const double number = table["tip"][row];
        if (std::isnan(number) ? tip == 0 : number == static_cast<double>(tip)) rows.push_back(row);
    }
    return rows;
}

std::vector<std::size_t> rows_of_crack(const NumberTable& faces, int crack, double increment) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < faces.rows; ++row)
        if (faces["increment"][row] == increment && faces["crack"][row] == crack) rows.push_back(row);
    std::ranges::sort(rows, {}, [&](std::size_t row) { return faces["s"][row]; });
    return rows;
}

std::vector<double> values_of(const NumberTable& table, const std::string& column,
                              const std::vector<std::size_t>& rows) {
    std::vector<double> values(rows.size(), std::numeric_limits<double>::quiet_NaN());
    if (!table.columns.contains(column)) return values;
    std::ranges::transform(rows, values.begin(), [&](std::size_t row) { return table[column][row]; });
    return values;
}

}  // namespace stria
