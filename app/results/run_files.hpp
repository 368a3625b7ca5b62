// The files of a run read back: a text as it is, summary.json as numbers, words and lists of words by their path.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace stria {

/// The members of a JSON object; those of objects within it as "timing.setup". Lists of anything but words and null are
/// left out.
struct JsonObject {
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> words;
    std::map<std::string, std::vector<std::string>> lists;

    /// NaN where it is missing.
    [[nodiscard]] double number(const std::string& path) const;
    /// Both are empty where it is missing.
    [[nodiscard]] std::string word(const std::string& path) const;
    [[nodiscard]] std::vector<std::string> list(const std::string& path) const;
};

/// All of a file; empty where there is none.
std::string read_text(const std::filesystem::path& path);

/// In the folder of a study.
inline constexpr const char* study_table = "study.csv";
inline constexpr const char* study_page = "study.html";
inline constexpr const char* convergence_table = "convergence.csv";
[[nodiscard]] bool holds_study(const std::filesystem::path& folder);
/// Its tables and its page; the runs that it has made stay.
void remove_study(const std::filesystem::path& folder);

/// Empty where there is no such file or it holds no JSON object.
JsonObject read_json(const std::filesystem::path& path);

}  // namespace stria
