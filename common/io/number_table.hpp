// CSV tables of numbers, read by their columns.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace stria {

/// Cells may be quoted, numbers may have a sign +. An empty cell is NaN, and so is a text.
struct NumberTable {
    std::map<std::string, std::vector<double>> columns;
    std::size_t rows = 0;
    std::size_t names_line = 0;  // of the file, from 1
    bool cut_off = false;        // a row has not as many cells as there are names: it and what follows is left out
    std::vector<std::size_t> lines = {};  // of the file, from 1: those of the rows, and of the one that is cut off
    std::string repeated = {};            // the first name that is given twice, so that its column means nothing

    /// Throws std::out_of_range where there is none of that name.
    [[nodiscard]] const std::vector<double>& operator[](const std::string& column) const { return columns.at(column); }
};

/// The first line that is not empty names the columns; empty lines are passed over. Without columns where there is no
/// such file.
NumberTable read_table(const std::filesystem::path& path);

/// Of the rows alone whose first cell is `wanted`: a long table need not be held as a whole.
NumberTable read_table(const std::filesystem::path& path, const std::function<bool(double)>& wanted);

}  // namespace stria
