#include "common/schema/value.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace stria::schema {
namespace {

std::string number_text(double number) {
    const std::string text = fmt::format("{}", number);
    return text.find_first_of(".enai") == std::string::npos ? text + ".0" : text;
}

template <class Items, class Text>
std::string joined(const Items& items, Text text, const char* open, const char* close) {
    std::vector<std::string> parts;
    for (const auto& item : items) parts.push_back(text(item));
    return fmt::format("{}{}{}", open, fmt::join(parts, ", "), close);
}

}  // namespace

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\')
            out += fmt::format("\\{}", letter);
        else if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f)
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(letter));
        else
            out += letter;
    }
    return out + '"';
}

std::optional<double> number_of(const Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(&value.data)) return *number;
    return std::nullopt;
}

std::string to_toml(const Value& value) {
    struct Printer {
        std::string operator()(std::monostate) const { return "(a date or time)"; }
        std::string operator()(bool truth) const { return truth ? "true" : "false"; }
        std::string operator()(std::int64_t whole) const { return fmt::format("{}", whole); }
        std::string operator()(double number) const { return number_text(number); }
        std::string operator()(const std::string& text) const { return quoted(text); }
        std::string operator()(const List& list) const { return joined(list, to_toml, "[", "]"); }
        std::string operator()(const Table& table) const {
            const auto pair = [](const Member& member) { return member.name + " = " + to_toml(member.value); };
            return table.empty() ? "{}" : joined(table, pair, "{ ", " }");
        }
    };
    return std::visit(Printer{}, value.data);
}

const Value* find(const Value& table, std::string_view name) {
    const auto* members = std::get_if<Table>(&table.data);
    if (members == nullptr) return nullptr;
    const auto found =
        std::find_if(members->begin(), members->end(), [name](const Member& m) { return m.name == name; });
    return found == members->end() ? nullptr : &found->value;
}

}  // namespace stria::schema
