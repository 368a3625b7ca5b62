// The files of a run read back: summary.json as numbers and words by their path.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace stria {

/// The members of a JSON object; those of objects within it as "timing.setup". Lists and null are left out.
struct JsonObject {
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> words;
};

/// Empty where there is no such file or it holds no JSON object.
JsonObject read_json(const std::filesystem::path& path);

}  // namespace stria
