// CSV tables that grow a row at a time: numbers in the shortest form that reads back the same, empty cells where a
// value is missing, every row on the disk's side of the program before the next is computed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace stria {

/// A value of a table. Nothing, and a number that is not finite, leave the cell empty.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string>;

class CsvWriter {
public:
    /// Starts a table with its header; an earlier file is replaced.
    CsvWriter(std::filesystem::path path, const std::vector<std::string>& columns);

    /// Continues a table after its first `rows` rows and drops those behind (--resume). Throws CaseError if the
    /// file has another header or fewer rows.
    CsvWriter(std::filesystem::path path, const std::vector<std::string>& columns, std::size_t rows);

    /// Throws FileFailure; the rows before stay whole.
    void row(std::span<const Cell> cells);

    /// Rows so far: what a checkpoint remembers.
    [[nodiscard]] std::size_t rows() const { return rows_; }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    void write_line(const std::string& line);

    std::filesystem::path path_;
    std::size_t columns_;
    std::size_t rows_ = 0;
    std::uintmax_t bytes_ = 0;  // of whole rows
    std::ofstream file_;
};

}  // namespace stria
