// The files of a run read back: summary.json as numbers and words by their path, tables by their columns.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace stria::study {

/// The members of a JSON object; those of objects within it as "timing.setup". Lists and null are left out.
struct JsonObject {
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> words;
};

/// Empty where there is no such file or it holds no JSON object.
JsonObject read_json(const std::filesystem::path& path);

/// A CSV table of numbers; an empty cell is NaN, and so is a text.
struct NumberTable {
    std::map<std::string, std::vector<double>> columns;
    std::size_t rows = 0;

    /// Throws std::out_of_range where there is none of that name.
    [[nodiscard]] const std::vector<double>& operator[](const std::string& column) const { return columns.at(column); }
};

/// Without columns where there is no such file. A last row that was cut off is dropped.
NumberTable read_table(const std::filesystem::path& path);

}  // namespace stria::study
