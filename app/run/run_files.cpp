#include "app/run/run_files.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

namespace stria {

namespace {

void collect(const nlohmann::json& object, const std::string& prefix, JsonObject& into) {
    for (const auto& [key, value] : object.items()) {
        if (value.is_object())
            collect(value, prefix + key + '.', into);
        else if (value.is_number())
            into.numbers[prefix + key] = value.get<double>();
        else if (value.is_string())
            into.words[prefix + key] = value.get<std::string>();
    }
}

}  // namespace

JsonObject read_json(const std::filesystem::path& path) {
    JsonObject object;
    std::ifstream file(path);
    const nlohmann::json parsed = nlohmann::json::parse(file, nullptr, false);
    if (parsed.is_object()) collect(parsed, "", object);
    return object;
}

}  // namespace stria
