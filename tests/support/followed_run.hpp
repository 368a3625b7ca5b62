// A run of one of our programs, followed while it writes, and its tables beside those of another one.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "common/index.hpp"
#include "common/io/number_table.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {

inline int rows_of(const std::string& table) {
    const std::string text = text_of(table);
    return static_cast<int>(std::ranges::count(text, '\n')) - 1;
}

/// Once history.csv has so many rows; false where the run has ended before.
inline bool wait_for_rows(Program& run, const std::string& output, int rows) {
    for (int k = 0; k < 20'000; ++k) {
        if (rows_of(output + "/history.csv") >= rows) return true;
        if (kill(run.pid(), 0) != 0) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
}

/// Of cycles.csv, without the column that holds times.
inline std::string without_times(const std::string& table) {
    std::istringstream lines(text_of(table));
    std::string line, kept;
    std::ptrdiff_t column = -1;
    while (std::getline(lines, line)) {
        Words cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
        if (column < 0) column = std::ranges::find(cells, "wall_s") - cells.begin();
        cells.at(at(column)).clear();
        for (const std::string& cell : cells) kept += cell + ',';
        kept += '\n';
    }
    return kept;
}

inline void expect_same_tables(const std::string& run, const std::string& undisturbed) {
    EXPECT_EQ(text_of(run + "/history.csv"), text_of(undisturbed + "/history.csv"));
    EXPECT_EQ(text_of(run + "/faces.csv"), text_of(undisturbed + "/faces.csv"));
    EXPECT_EQ(without_times(run + "/cycles.csv"), without_times(undisturbed + "/cycles.csv"));
}

/// To rounding, what tells of a state.
inline void expect_tables_alike(const std::string& run, const std::string& undisturbed) {
    const NumberTable a = read_table(undisturbed + "/history.csv"), b = read_table(run + "/history.csv");
    ASSERT_EQ(b.rows, a.rows);
    for (const char* column : {"load_factor", "load", "displacement", "a", "K_I", "J", "CMOD", "CTOD", "contact_length",
                               "plastic_zone", "dissipation"}) {
        double largest = 0.0;
        for (const double value : a[column]) largest = std::max(largest, std::abs(value));
        for (std::size_t k = 0; k < a.rows; ++k)
            EXPECT_NEAR(b[column][k], a[column][k], 1e-9 * largest) << column << ", row " << k;
    }
}

}  // namespace stria::test
