// The rows that belong together in the tables of a run.
#pragma once

#include <string>
#include <vector>

#include "common/io/number_table.hpp"

namespace stria {

/// Rows of that tip, in their order. Those of a scene without tips count as those of tip 0.
std::vector<std::size_t> rows_of_tip(const NumberTable& table, std::size_t tip);

/// Rows of faces.csv of a crack at an increment, from the crack's first point on.
std::vector<std::size_t> rows_of_crack(const NumberTable& faces, int crack, double increment);

/// Those rows of a column; NaN where the table has no such column.
std::vector<double> values_of(const NumberTable& table, const std::string& column,
                              const std::vector<std::size_t>& rows);

}  // namespace stria
