#include "app/results/run_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>

#include "common/io/json.hpp"

namespace stria {

namespace {

void collect(const Json& object, const std::string& prefix, JsonObject& into) {
    for (const auto& [key, value] : object.items()) {
        if (value.is_object())
            collect(value, prefix + key + '.', into);
        else if (value.is_number())
            into.numbers[prefix + key] = value.get<double>();
        else if (value.is_string())
            into.words[prefix + key] = value.get<std::string>();
        else if (value.is_array() && std::ranges::all_of(value, [](const auto& item) { return item.is_string(); }))
            into.lists[prefix + key] = value.get<std::vector<std::string>>();
    }
}

}  // namespace

double JsonObject::number(const std::string& path) const {
    const auto found = numbers.find(path);
    return found != numbers.end() ? found->second : std::numeric_limits<double>::quiet_NaN();
}

std::string JsonObject::word(const std::string& path) const {
    const auto found = words.find(path);
    return found != words.end() ? found->second : "";
}

std::vector<std::string> JsonObject::list(const std::string& path) const {
    const auto found = lists.find(path);
    return found != lists.end() ? found->second : std::vector<std::string>();
}

std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

bool holds_study(const std::filesystem::path& folder) {
    std::error_code problem;
    return std::filesystem::exists(folder / study_table, problem);
}

void remove_study(const std::filesystem::path& folder) {
    for (const char* file : {study_table, study_page, convergence_table}) std::filesystem::remove(folder / file);
}

JsonObject read_json(const std::filesystem::path& path) {
    JsonObject object;
    std::ifstream file(path);
    const Json parsed = Json::parse(file, nullptr, false);
    if (parsed.is_object()) collect(parsed, "", object);
    return object;
}

}  // namespace stria
