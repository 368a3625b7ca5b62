#include "common/case/schema/case_file.hpp"

#include "common/case/checks/case_checks.hpp"
#include "common/case/loads/load_increments.hpp"
#include "common/case/loads/spectrum.hpp"
#include "common/case/schema/case_schema.hpp"
#include "common/case/schema/not_in_this_version.hpp"
#include "common/case/schema/region_schema.hpp"
#include "common/error.hpp"
#include "common/io/checksum.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <toml++/toml.h>

namespace stria {

namespace {

using schema::Key;
using schema::List;
using schema::Member;
using schema::Table;
using schema::Value;

constexpr std::uintmax_t largest_file = 100'000'000;  // bytes
constexpr int deepest_key = 50;

Value from_toml(const toml::node& node, bool with_lines) {
    Value value;
    if (with_lines) value.line = static_cast<int>(node.source().begin.line);
    if (const toml::table* table = node.as_table()) {
        Table members;
        for (const auto& [key, entry] : *table)
            members.push_back({std::string(key.str()), from_toml(entry, with_lines)});
        // The library sorts by name; complaints should come in the order of the file.
        std::ranges::stable_sort(members, {}, [](const Member& member) { return member.value.line; });
        value.data = std::move(members);
    } else if (const toml::array* array = node.as_array()) {
        List list;
        for (const toml::node& entry : *array) list.push_back(from_toml(entry, with_lines));
        value.data = std::move(list);
    } else if (const auto* text = node.as_string()) {
        value.data = text->get();
    } else if (const auto* whole = node.as_integer()) {
        value.data = whole->get();
    } else if (const auto* number = node.as_floating_point()) {
        value.data = number->get();
    } else if (const auto* truth = node.as_boolean()) {
        value.data = truth->get();
    }
    return value;
}

std::string one_line(std::string_view text) {
    std::string line(text);
    std::ranges::replace(line, '\n', ' ');
    return line;
}

std::string text_of_file(const std::string& path) {
    std::error_code problem;
    const std::filesystem::file_status status = std::filesystem::status(path, problem);
    if (std::filesystem::is_directory(status)) throw CaseError(path + ": is a folder, not a case file");
    // Two programs read the case, one after the other: a pipe gives it once, a device has no end.
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw CaseError(path + ": is a pipe or a device, not a case file");
    const std::uintmax_t size = std::filesystem::file_size(path, problem);
    if (!problem && size > largest_file)
        throw CaseError(fmt::format("{}: has {} bytes, a case file has at most {}", path, size, largest_file));
    std::ifstream file(path, std::ios::binary);
    if (!file) throw CaseError(path + ": cannot be read, no such case file");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Of a key, a number or a word, joined by dots. What reads the case walks through its tables by recursion.
void check_depth(std::string_view text, const std::string& path) {
    int line = 1, parts = 0;
    char quote = 0;
    bool comment = false;
    for (const char letter : text) {
        if (letter == '\n') {
            ++line;
            parts = 0;
            quote = 0;
            comment = false;
        } else if (comment) {
            continue;
        } else if (quote != 0) {
            if (letter == quote) quote = 0;
        } else if (letter == '"' || letter == '\'') {
            quote = letter;
        } else if (letter == '#') {
            comment = true;
        } else if (letter == '.') {
            if (++parts > deepest_key)
                throw CaseError(fmt::format("{}:{}: a key of more than {} parts", path, line, deepest_key));
        } else if (std::string_view(",[]{}=").find(letter) != std::string_view::npos) {
            parts = 0;
        }
    }
}

Value parse_file(const std::string& path) {
    try {
        const std::string text = text_of_file(path);
        check_depth(text, path);
        Value root = from_toml(toml::parse(text, path), true);
        root.line = 1;
        return root;
    } catch (const toml::parse_error& error) {
        const toml::source_position at = error.source().begin;
        throw CaseError(fmt::format("{}:{}:{}: {}", path, at.line, at.column, one_line(error.description())));
    }
}

/// "strain" may stand for "\"strain\"", but what begins like a list, table or quoted text must be one.
Value parse_override(const std::string& text, const std::string& whole) {
    try {
        const toml::table table = toml::parse("value = " + text);
        if (table.size() == 1) return from_toml(*table.get("value"), false);
    } catch (const toml::parse_error& error) {
        if (!text.empty() && std::string_view("[{\"'").find(text.front()) != std::string_view::npos)
            throw CaseError(fmt::format("--set {}: {}", whole, one_line(error.description())));
    }
    return {.data = text};
}

/// The entry `name` of a table, made where missing, or an entry of a list by its number.
Value& descend(Value& parent, const std::string& name, const std::string& whole) {
    if (auto* list = std::get_if<List>(&parent.data)) {
        std::size_t index = 0;
        const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
        if (error != std::errc{} || end != name.data() + name.size() || index >= list->size())
            throw CaseError(
                fmt::format("--set {}: \"{}\" is no entry of a list of {}, counted from 0", whole, name, list->size()));
        return (*list)[index];
    }
    if (!std::holds_alternative<Table>(parent.data)) parent = {.data = Table{}};
    auto& table = std::get<Table>(parent.data);
    const auto found = std::ranges::find(table, name, &Member::name);
    return found != table.end() ? found->value : table.emplace_back(Member{name, {.data = Table{}}}).value;
}

void apply_override(Value& root, const std::string& whole) {
    const std::size_t equals = whole.find('=');
    if (equals == std::string::npos || equals == 0) throw CaseError(fmt::format("--set {}: must be key=value", whole));
    const auto trimmed = [](const std::string& text) {
        const std::size_t first = text.find_first_not_of(' ');
        return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
    };
    check_depth(whole.substr(0, equals), "--set");
    std::istringstream path(trimmed(whole.substr(0, equals)));
    Value* target = &root;
    for (std::string name; std::getline(path, name, '.');) target = &descend(*target, name, whole);
    *target = parse_override(trimmed(whole.substr(equals + 1)), whole);
}

std::string name_from(const std::string& path) {
    const std::filesystem::path absolute = std::filesystem::weakly_canonical(path);
    const bool standard = absolute.filename() == "case.toml" && absolute.parent_path().has_filename();
    return (standard ? absolute.parent_path().filename() : absolute.stem()).string();
}

/// One line per key: its value with the unit, or a comment that it is absent.
std::string lines_of(const Value& table, const std::vector<Key>& keys) {
    std::string text;
    for (const Key& key : keys) {
        const Value* value = schema::find(table, key.name);
        const std::string unit = key.unit.empty() ? "" : "  # " + key.unit;
        if (value != nullptr) text += fmt::format("{} = {}{}\n", key.name, schema::to_toml(*value), unit);
        // What merely stands for another key is never written.
        else if (key.name != "ratio")
            text += fmt::format("# {}: absent\n", key.name);
    }
    return text;
}

}  // namespace

Case read_case(const std::string& path, const std::vector<std::string>& overrides) {
    Value root = parse_file(path);
    for (const std::string& override_text : overrides) apply_override(root, override_text);
    schema::check_available(root, not_in_this_version(), path);
    schema::check_known(root, case_schema().keys(), path);
    Case scene = case_schema().read(root, {}, {path, ""});
    if (scene.name.empty()) scene.name = name_from(path);
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    if (scene.mesh.file) scene.mesh.file = (folder / *scene.mesh.file).lexically_normal().string();
    if (scene.load.spectrum) take_spectrum(scene, std::filesystem::path(path).parent_path());
    if (scene.initial_stress && scene.initial_stress->file) {
        const std::filesystem::path file = std::filesystem::path(path).parent_path() / *scene.initial_stress->file;
        scene.initial_stress->grid = read_stress_grid(file);
        scene.initial_stress->file.reset();
    }
    choose_increments(scene);
    check_load(scene, root, {path, ""});
    return scene;
}

std::string resolved_toml(const Case& scene) {
    const Value root = case_schema().write(scene);
    std::string scalars;
    std::string sections;
    for (const Key& key : case_schema().keys()) {
        const Value* value = schema::find(root, key.name);
        if (value == nullptr) {
            sections += fmt::format("\n# [{}]: absent\n", key.name);
        } else if (key.keys.empty()) {
            scalars += fmt::format("{} = {}\n", key.name, schema::to_toml(*value));
        } else if (key.repeated) {
            for (const Value& entry : std::get<List>(value->data))
                sections += fmt::format("\n[[{}]]\n{}", key.name, lines_of(entry, key.keys));
        } else {
            sections += fmt::format("\n[{}]\n{}", key.name, lines_of(*value, key.keys));
        }
    }
    return scalars + sections;
}

std::uint64_t digest(const Case& scene) { return checksum(resolved_toml(scene)); }

}  // namespace stria
