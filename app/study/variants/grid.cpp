#include "app/study/variants/grid.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/error.hpp"

namespace stria::study {

namespace {

constexpr std::size_t longest_name = 100;  // characters of a folder; file systems allow 255

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return "";
    return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

std::pair<std::string, std::string> split_at_equals(const std::string& text, const std::string& complaint) {
    const std::size_t equals = text.find('=');
    std::string key = trimmed(text.substr(0, equals));
    if (equals == std::string::npos || key.empty()) throw CaseError(complaint);
    return {std::move(key), trimmed(text.substr(equals + 1))};
}

bool is_plain(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("._+-=").find(c) != std::string_view::npos;
}

/// Of a number or a word.
bool in_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("._+-").find(c) != std::string_view::npos;
}

/// How many characters all have in common, from wherever `letter` counts.
std::size_t shared_text(const std::vector<std::string>& values, auto letter) {
    std::size_t shared = values.front().size();
    for (const std::string& value : values) {
        shared = std::min(shared, value.size());
        for (std::size_t k = 0; k < shared; ++k)
            if (letter(value, k) != letter(values.front(), k)) shared = k;
    }
    return shared;
}

}  // namespace

std::vector<std::string> split_list(std::string_view text) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    int depth = 0;
    char quote = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char c = text[k];
        if (quote != 0) {
            if (c == '\\' && quote == '"') ++k;
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '[' || c == '{') {
            ++depth;
        } else if (c == ']' || c == '}') {
            --depth;
        } else if (c == ',' && depth == 0) {
            parts.push_back(trimmed(text.substr(begin, k - begin)));
            begin = k + 1;
        }
    }
    parts.push_back(trimmed(text.substr(begin)));
    return parts;
}

std::optional<double> number_in(const std::string& text) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

Axis make_axis(const std::string& key, const std::vector<std::string>& values, const std::string& option) {
    for (auto value = values.begin(); value != values.end(); ++value) {
        if (value->empty()) throw CaseError(fmt::format("{} {}: a value is missing; must be v1,v2,...", option, key));
        if (std::find(values.begin(), value, *value) != value)
            throw CaseError(fmt::format("{} {}: the value {} is given twice", option, key, *value));
    }
    return {key, values};
}

Axis parse_axis(const std::string& text, const std::string& option) {
    const auto [key, values] = split_at_equals(text, fmt::format("{} {}: must be key=v1,v2,...", option, text));
    return make_axis(key, split_list(values), option);
}

Settings parse_settings(const std::string& text, const std::string& option) {
    Settings settings;
    for (const std::string& part : split_list(text)) {
        const std::string complaint = fmt::format("{} {}: must be key=value,...", option, text);
        auto [key, value] = split_at_equals(part, complaint);
        if (value.empty()) throw CaseError(complaint);
        if (std::ranges::count(settings, key, &Setting::key) > 0)
            throw CaseError(fmt::format("{} {}: {} is given twice", option, text, key));
        settings.push_back({std::move(key), std::move(value)});
    }
    return settings;
}

void check_distinct(const std::vector<Axis>& axes, const std::vector<std::string>& fixed) {
    for (auto axis = axes.begin(); axis != axes.end(); ++axis) {
        if (std::find_if(axes.begin(), axis, [&](const Axis& other) { return other.key == axis->key; }) != axis)
            throw CaseError(fmt::format("--over {}: the key is there twice; give all its values at once", axis->key));
        for (const std::string& setting : fixed)
            if (trimmed(setting.substr(0, setting.find('='))) == axis->key)
                throw CaseError(fmt::format("--over {}: the key has one value already, --set {}", axis->key, setting));
    }
}

std::vector<Settings> combinations(const std::vector<Axis>& axes) {
    std::vector<Settings> all = {{}};
    for (const Axis& axis : axes) {
        std::vector<Settings> longer;
        for (const Settings& settings : all) {
            for (const std::string& value : axis.values) {
                longer.push_back(settings);
                longer.back().push_back({axis.key, value});
            }
        }
        all = std::move(longer);
    }
    return all;
}

Settings replaced(Settings settings, const Settings& by) {
    for (const Setting& setting : by) {
        const auto found = std::ranges::find(settings, setting.key, &Setting::key);
        if (found != settings.end())
            found->value = setting.value;
        else
            settings.push_back(setting);
    }
    return settings;
}

Settings without(Settings settings, std::size_t axis) {
    settings.erase(settings.begin() + static_cast<std::ptrdiff_t>(axis));
    return settings;
}

std::string to_text(const Settings& settings) {
    std::vector<std::string> parts;
    for (const Setting& setting : settings) parts.push_back(setting.key + '=' + setting.value);
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<std::string> differing_parts(const std::vector<std::string>& values) {
    if (values.size() < 2) return values;
    std::size_t before = shared_text(values, [](const std::string& text, std::size_t k) { return text[k]; });
    std::size_t behind =
        shared_text(values, [](const std::string& text, std::size_t k) { return text[text.size() - 1 - k]; });
    const std::string& first = values.front();
    while (before > 0 && in_word(first[before - 1])) --before;
    while (behind > 0 && in_word(first[first.size() - behind])) --behind;
    std::vector<std::string> parts;
    for (const std::string& value : values) {
        if (before + behind >= value.size()) return values;
        parts.push_back(value.substr(before, value.size() - before - behind));
    }
    return parts;
}

std::string folder_name(int number, int count, const Settings& settings) {
    const auto digits = std::max<std::size_t>(2, std::to_string(count).size());
    std::string name = fmt::format("{:0{}}", number, digits);
    for (const Setting& setting : settings) {
        name += '-';
        // What is not plain becomes one underscore a stretch: "[[1, 2]]" is "_1_2_".
        for (const char c : setting.key + '=' + setting.value)
            if (is_plain(c) || name.back() != '_') name += is_plain(c) ? c : '_';
    }
    return name.substr(0, longest_name);
}

}  // namespace stria::study
