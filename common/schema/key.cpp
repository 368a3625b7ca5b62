#include "common/schema/key.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

#include "common/error.hpp"

namespace stria::schema {
namespace {

constexpr std::size_t longest_excerpt = 60;  // characters of a value in an error text

std::string excerpt(const Value& value) {
    if (const auto* number = std::get_if<double>(&value.data)) return fmt::format("{}", *number);
    const std::string text = to_toml(value);
    return text.size() <= longest_excerpt ? text : text.substr(0, longest_excerpt) + "...";
}

}  // namespace

Place Place::inside(std::string_view name) const {
    return {file, path.empty() ? std::string(name) : fmt::format("{}.{}", path, name)};
}

Key& Key::in(std::string its_unit) { return unit = std::move(its_unit), *this; }

Key& Key::positive() {
    rules.push_back({[](double number) { return number > 0.0; }, "> 0"});
    return *this;
}

Key& Key::at_least(double bound) {
    rules.push_back({[bound](double number) { return number >= bound; }, fmt::format(">= {}", bound)});
    return *this;
}

Key& Key::below(double bound) {
    rules.push_back({[bound](double number) { return number < bound; }, fmt::format("< {}", bound)});
    return *this;
}

Key& Key::at_most(double bound) {
    rules.push_back({[bound](double number) { return number <= bound; }, fmt::format("<= {}", bound)});
    return *this;
}

Key& Key::even() {
    rules.push_back({[](double number) { return std::fmod(number, 2.0) == 0.0; }, "even"});
    return *this;
}

Key& Key::power_of_two() {
    const auto holds = [](double number) {
        int exponent = 0;
        return std::frexp(number, &exponent) == 0.5 && number >= 1.0;
    };
    rules.push_back({holds, "a power of two (1, 2, 4, ...)"});
    return *this;
}

Key& Key::one_of(std::vector<std::string> allowed) {
    type = "word";
    words = std::move(allowed);
    return *this;
}

Key& Key::must_be_given() { return required = true, *this; }
Key& Key::or_else(std::string default_text) { return fallback = std::move(default_text), *this; }
Key& Key::says(std::string its_sentence) { return sentence = std::move(its_sentence), *this; }

std::string Key::range() const {
    if (!words.empty()) return fmt::format("{}", fmt::join(words, " | "));
    std::vector<std::string> texts;
    for (const Rule& rule : rules) texts.push_back(rule.text);
    return fmt::format("{}", fmt::join(texts, " and "));
}

void reject(const Place& place, const Value& value, const Key& key, const std::string& demand) {
    const bool with_unit = !key.unit.empty() && number_of(value);
    reject(place, value.line, fmt::format("= {}{} {}", excerpt(value), with_unit ? " " + key.unit : "", demand));
}

void reject(const Place& place, int line, const std::string& sentence) {
    const std::string where = line > 0 ? fmt::format("{}:{}", place.file, line) : "--set";
    throw CaseError(fmt::format("{}: {}{}{}", where, place.path, place.path.empty() ? "" : " ", sentence));
}

}  // namespace stria::schema
