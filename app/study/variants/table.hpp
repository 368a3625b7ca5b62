// A study as a table: one row per variant.
#pragma once

#include <string>
#include <vector>

#include "app/study/variants/grid.hpp"
#include "app/study/variants/outcome.hpp"
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

/// A study, as far as it has come: what its page and its charts are made of.
struct Report {
    std::string title;
    std::string case_path;
    std::string version;
    std::vector<std::string> fixed;  // key=value, the same in all variants
    std::vector<Axis> axes;
    std::vector<Row> rows;
    std::vector<Row> references;  // runs beyond the variants
    std::string reference;        // in words; empty: none
};

/// Header and cells of study.csv; the columns of errors only if there is a reference.
std::vector<std::string> columns(const std::vector<Axis>& axes, bool with_errors);
std::vector<Cell> cells(const Row& row, bool with_errors);

}  // namespace stria::study
