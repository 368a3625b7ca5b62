#include "common/io/csv.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>

#include "common/error.hpp"
#include "common/io/file_failure.hpp"
#include "common/io/whole_file.hpp"

namespace stria {
namespace {

/// Quoted where a comma, a quote or a line break would end the cell (RFC 4180).
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"') result += '"';
        result += c;
    }
    return result + '"';
}

std::string text_of(const Cell& cell) {
    if (const auto* integer = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *integer);
    if (const auto* number = std::get_if<double>(&cell))
        return std::isfinite(*number) ? fmt::format("{}", *number) : "";
    if (const auto* text = std::get_if<std::string>(&cell)) return quoted(*text);
    return "";
}

std::string header_of(const std::vector<std::string>& columns) { return fmt::format("{}\n", fmt::join(columns, ",")); }

/// Header and first `rows` rows of the table on the disk. Our tables have no line breaks inside cells.
std::string kept_part(const std::filesystem::path& path, const std::string& header, std::size_t rows) {
    std::ifstream file(path, std::ios::binary);
    std::string kept, line;
    for (std::size_t lines = 0; lines <= rows; ++lines) {
        if (!std::getline(file, line) || file.eof()) {
            throw CaseError(fmt::format("{}: cannot go on after {} rows, it has fewer; put the table back that the "
                                        "run has left, or start anew with --force",
                                        path.string(), rows));
        }
        kept += line + '\n';
        if (lines == 0 && kept != header)
            throw CaseError(path.string() + ": cannot go on, it has other columns; start anew with --force");
    }
    return kept;
}

}  // namespace

CsvWriter::CsvWriter(std::filesystem::path path, const std::vector<std::string>& columns)
    : path_(std::move(path)), columns_(columns.size()), file_(path_, std::ios::binary | std::ios::trunc) {
    write_line(header_of(columns));
}

CsvWriter::CsvWriter(std::filesystem::path path, const std::vector<std::string>& columns, std::size_t rows)
    : path_(std::move(path)), columns_(columns.size()), rows_(rows) {
    write_whole_text(path_, kept_part(path_, header_of(columns), rows));
    bytes_ = std::filesystem::file_size(path_);
    file_.open(path_, std::ios::binary | std::ios::app);
    if (!file_) throw FileFailure::of_writing(path_, errno);
}

void CsvWriter::row(std::span<const Cell> cells) {
    require(cells.size() == columns_, "a CSV row has one cell a column");
    std::vector<std::string> texts;
    for (const Cell& cell : cells) texts.push_back(text_of(cell));
    write_line(fmt::format("{}\n", fmt::join(texts, ",")));
    ++rows_;
}

void CsvWriter::write_line(const std::string& line) {
    file_.write(line.data(), static_cast<std::streamsize>(line.size())).flush();
    if (!file_) {
        const int error = errno;
        std::error_code ignored;
        std::filesystem::resize_file(path_, bytes_, ignored);  // no row is left in part
        throw FileFailure::of_writing(path_, error);
    }
    bytes_ += line.size();
}

}  // namespace stria
