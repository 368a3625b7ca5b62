// The table of a study: one row per variant.
#pragma once

#include <string>
#include <vector>

#include "app/study/grid.hpp"
#include "app/study/outcome.hpp"
#include "common/io/csv.hpp"

namespace stria::study {

/// Relative: an error up to it says no more than that results are equal.
inline constexpr double rounding = 1e-9;

struct Row {
    int number = 0;  // from 1; 0: a reference that is no variant
    Settings settings = {};
    std::string folder = {};  // within that of the study
    Outcome outcome = {};
    std::string reference = {};                 // the folder of its reference; empty: none
    std::map<std::string, double> errors = {};  // by result

    /// NaN where it is missing.
    [[nodiscard]] double error(const std::string& result) const;
};

/// Header and cells of study.csv; the columns of errors only if there is a reference.
std::vector<std::string> columns(const std::vector<Axis>& axes, bool with_errors);
std::vector<Cell> cells(const Row& row, bool with_errors);

}  // namespace stria::study
