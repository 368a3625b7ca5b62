// The reference of the case file's keys, as text for the terminal and as Markdown; both from the declarations.
#include "common/case/schema/case_file.hpp"
#include "common/case/schema/case_schema.hpp"
#include "common/case/schema/not_in_this_version.hpp"
#include "common/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace stria {

namespace {

using schema::Key;
using schema::NotYet;

std::string default_of(const Key& key) {
    if (key.required) return "required";
    return key.fallback.empty() ? "" : "default " + key.fallback;
}

std::string paragraph(const Key& key, const std::string& path) {
    std::vector<std::string> facts = {key.type};
    for (const std::string& fact : {key.unit, key.range(), default_of(key)})
        if (!fact.empty()) facts.push_back(fact);
    return fmt::format("{}\n    {}\n    {}\n", path, fmt::join(facts, "; "), key.sentence);
}

std::string paragraphs(const std::vector<Key>& keys, const std::string& prefix, const std::string& wanted) {
    std::string text;
    for (const Key& key : keys) {
        const std::string path = prefix + key.name;
        const bool shown = wanted.empty() || path == wanted || path.starts_with(wanted + ".");
        if (shown) text += paragraph(key, path);
        text += paragraphs(key.keys, path + ".", wanted);
    }
    return text;
}

/// A bar would end the cell of a Markdown table.
std::string cell(const std::string& text) {
    std::string out;
    for (const char letter : text) {
        if (letter == '|') out += '\\';
        out += letter;
    }
    return out;
}

std::string rows(const std::vector<Key>& keys, const std::string& prefix) {
    std::string text;
    for (const Key& key : keys) {
        const std::string standard = key.required ? "required" : key.fallback;
        text += fmt::format("| `{}{}` | {} | {} | {} | {} | {} |\n", prefix, key.name, cell(key.type), key.unit,
                            cell(standard), cell(key.range()), cell(key.sentence));
        text += rows(key.keys, prefix + key.name + ".");
    }
    return text;
}

std::string section_text(const std::string& title, const std::string& sentence, const std::vector<Key>& keys) {
    return fmt::format(
        "\n## {}\n\n{}\n\n| key | type | unit | default | range | meaning |\n|---|---|---|---|---|---|\n{}", title,
        sentence, rows(keys, ""));
}

std::string table_of_missing() {
    std::string text = "\n## Not in this version\n\nThese are recognised and refused.\n\n| key | this version |\n"
                       "|---|---|\n";
    for (const NotYet& entry : not_in_this_version())
        text += fmt::format("| `{}` | {} |\n", entry.path, cell(entry.instead));
    return text;
}

}  // namespace

std::string explain(const std::string& key) {
    const std::string wanted = schema::without_numbers(key);
    const std::string text = paragraphs(case_schema().keys(), "", wanted);
    if (!text.empty()) return text;
    for (const NotYet& entry : not_in_this_version())
        if (entry.path == wanted)
            return fmt::format("{}\n    Not in this version{}.\n", wanted,
                               entry.instead.empty() ? "" : ": " + entry.instead);
    throw CaseError(
        fmt::format("{} is not a known key; {}", key, schema::instead_of_key(wanted, case_schema().keys())));
}

std::string case_reference_markdown() {
    std::string text =
        "# Reference of the case file\n\n"
        "Written by `stria explain --markdown` from the declarations in `common/case/schema/*_schema.cpp`; "
        "do not edit.\nUnits are N, mm, MPa throughout. A range holds for finite numbers only.\n";
    std::vector<Key> top;
    std::string sections;
    for (const Key& key : case_schema().keys()) {
        const char* title = key.repeated ? "`[[{}]]`" : "`[{}]`";
        if (key.keys.empty())
            top.push_back(key);
        else
            sections += section_text(fmt::format(fmt::runtime(title), key.name), key.sentence, key.keys);
    }
    return text + section_text("Top of the file", "Before the first section.", top) + sections + table_of_missing();
}

}  // namespace stria
