#include "coarse/mesh_file/abaqus_lines.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <utility>

#include "common/error.hpp"
#include "common/io/byte_order_mark.hpp"

namespace stria::coarse {
namespace {

std::string trimmed(const std::string& text) {
    constexpr const char* blank = " \t\r";
    const std::size_t first = text.find_first_not_of(blank);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(trimmed(cell));
    return cells;
}

std::string without_quotes(const std::string& text) {
    const bool quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
    return quoted ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

std::string upper_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string Keyword::value(const std::string& parameter) const {
    const auto found = parameters.find(parameter);
    return found != parameters.end() ? found->second : "";
}

AbaqusLines::AbaqusLines(std::string text, std::string name) : text_(std::move(text)), name_(std::move(name)) {}

bool AbaqusLines::next_line() {
    if (std::exchange(waits_, false)) return true;
    while (std::getline(text_, line_)) {
        if (++number_ == 1 && line_.starts_with(byte_order_mark)) line_.erase(0, byte_order_mark.size());
        line_ = trimmed(line_);
        if (!line_.empty() && !line_.starts_with("**")) return true;
    }
    return false;
}

bool AbaqusLines::next_keyword(Keyword& keyword) {
    do {
        if (!next_line()) return false;
    } while (!line_.starts_with('*'));
    std::string whole = line_;
    while (whole.ends_with(',') && next_line()) whole += line_;  // a keyword may go on
    const std::vector<std::string> cells = split(whole);
    keyword = {upper_case(cells[0]), {}};
    for (std::size_t k = 1; k < cells.size(); ++k) {
        const std::size_t equals = cells[k].find('=');
        const std::string value = equals == std::string::npos ? "" : trimmed(cells[k].substr(equals + 1));
        keyword.parameters[upper_case(trimmed(cells[k].substr(0, equals)))] = without_quotes(value);
    }
    return true;
}

bool AbaqusLines::next_data(std::vector<std::string>& cells) {
    if (!next_line()) return false;
    waits_ = line_.starts_with('*');
    if (!waits_) cells = split(line_);
    return !waits_;
}

std::int64_t AbaqusLines::whole(const std::string& cell) const {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    if (error != std::errc{} || end != cell.data() + cell.size())
        complain(fmt::format("expects a whole number, and has \"{}\"", cell.substr(0, 40)));
    return number;
}

double AbaqusLines::real(const std::string& cell) const {
    if (cell.empty()) return 0.0;
    std::string digits = cell.front() == '+' ? cell.substr(1) : cell;
    std::ranges::replace(digits, 'D', 'E');  // Fortran's
    std::ranges::replace(digits, 'd', 'e');
    double number = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc{} || end != digits.data() + digits.size())
        complain(fmt::format("expects a number, and has \"{}\"", cell.substr(0, 40)));
    return number;
}

void AbaqusLines::complain(const std::string& what) const {
    throw CaseError(fmt::format("{}:{}: {}", name_, number_, what));
}

}  // namespace stria::coarse
