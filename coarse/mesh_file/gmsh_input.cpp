#include "coarse/mesh_file/gmsh_input.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fmt/format.h>
#include <utility>

#include "common/error.hpp"
#include "common/io/byte_order_mark.hpp"

namespace stria::coarse {
namespace {

constexpr std::string_view blank = " \t\r\n";

}  // namespace

GmshInput::GmshInput(std::string text, std::string name) : text_(std::move(text)), name_(std::move(name)) {
    if (text_.starts_with(byte_order_mark)) place_ = byte_order_mark.size();
}

void GmshInput::be_binary() {
    binary_ = true;
    skip_line();  // bytes begin with the next
    if (integer() != 1) complain("has the byte order of another machine; write it anew, or as text");
}

std::optional<std::string> GmshInput::next_section() {
    place_ = text_.find_first_not_of(blank, place_);
    if (place_ == std::string::npos) return std::nullopt;
    if (text_[place_] != '$') complain("expects a section, which begins with $");
    std::string section(word().substr(1));
    if (section.starts_with("End")) complain(fmt::format("${} ends a section that has not begun", section));
    skip_line();  // the bytes of a binary section begin with the next
    return section;
}

void GmshInput::end_section(const std::string& section) {
    if (word() != "$End" + section) complain(fmt::format("expects $End{}: the section has more than it says", section));
}

void GmshInput::skip_section(const std::string& section) {
    const std::string end = "$End" + section;
    const std::size_t found = text_.find(end, place_);
    if (found == std::string::npos) complain(fmt::format("${} has no {}", section, end));
    place_ = found + end.size();
}

void GmshInput::skip_line() {
    const std::size_t end = text_.find('\n', place_);
    place_ = end == std::string::npos ? text_.size() : end + 1;
}

int GmshInput::integer() { return binary_ ? bytes<int>() : parsed<int>(); }

std::int64_t GmshInput::count() {
    const auto number = binary_ ? bytes<std::int64_t>() : parsed<std::int64_t>();
    if (number < 0) complain(fmt::format("expects a number that is not negative, and has {}", number));
    return number;
}

double GmshInput::real() { return binary_ ? bytes<double>() : parsed<double>(); }

int GmshInput::text_integer() { return parsed<int>(); }
double GmshInput::text_real() { return parsed<double>(); }

std::string GmshInput::quoted() {
    const std::size_t from = text_.find_first_not_of(blank, place_);
    const std::size_t to = from == std::string::npos ? from : text_.find_first_of("\"\n", from + 1);
    if (to == std::string::npos || text_[from] != '"' || text_[to] != '"') complain("expects a name in quotes");
    place_ = to + 1;
    return text_.substr(from + 1, to - from - 1);
}

void GmshInput::complain(const std::string& what) const {
    const std::size_t place = std::min(place_, text_.size());
    if (binary_) throw CaseError(fmt::format("{}: byte {}: {}", name_, place, what));
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(place), '\n');
    throw CaseError(fmt::format("{}:{}: {}", name_, line, what));
}

std::string_view GmshInput::word() {
    const std::size_t from = text_.find_first_not_of(blank, place_);
    if (from == std::string::npos) complain("ends too early");
    place_ = std::min(text_.find_first_of(blank, from), text_.size());
    return std::string_view(text_).substr(from, place_ - from);
}

template <class T> T GmshInput::parsed() {
    std::string_view digits = word();
    const std::string_view whole = digits;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    T number{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc{} || end != digits.data() + digits.size())
        complain(fmt::format("expects a number, and has \"{}\"", whole.substr(0, 40)));
    return number;
}

template <class T> T GmshInput::bytes() {
    if (text_.size() - place_ < sizeof(T)) complain("ends too early");
    T number;
    std::memcpy(&number, text_.data() + place_, sizeof(T));
    place_ += sizeof(T);
    return number;
}

}  // namespace stria::coarse
