// The table behind a chart: what is drawn and what can be taken from the page are the same numbers.
#pragma once

#include <string>
#include <vector>

#include "app/charts/chart.hpp"
#include "common/io/number_table.hpp"

namespace stria::charts {

struct Sheet {
    struct Column {
        std::string name;
        std::vector<double> values;  // NaN where one is missing
    };
    std::string name;  // of the file that a reader takes
    std::vector<Column> columns = {};

    /// Throws std::out_of_range where there is none of that name.
    [[nodiscard]] const std::vector<double>& operator[](const std::string& column) const;
};

/// Those rows and columns of a table of a run, under their own names.
Sheet sheet_of(const NumberTable& table, const std::string& name, const std::vector<std::size_t>& rows,
               const std::vector<std::string>& columns);

/// A header and one line per row; each number in the shortest form that reads back the same, as in the tables of a run.
std::string csv(const Sheet& sheet);

/// A link that gives the table as a file, without network and without script.
std::string csv_link(const Sheet& sheet);

/// One column over another, under its own name unless another is given.
Curve curve_of(const Sheet& sheet, const std::string& x, const std::string& y, const std::string& name = "");

}  // namespace stria::charts
