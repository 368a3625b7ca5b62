#include "coarse/results/result_files.hpp"

#include <system_error>

namespace stria::coarse {

namespace {

/// A folder that cannot be looked into holds nothing.
bool is_there(const std::filesystem::path& file) {
    std::error_code problem;
    return std::filesystem::exists(file, problem);
}

}  // namespace

std::filesystem::path previous_checkpoint(std::filesystem::path path) {
    return path.replace_filename(path.stem().string() + ".previous" + path.extension().string());
}

bool has_checkpoint(const std::filesystem::path& folder) {
    const std::filesystem::path newest = folder / result_files::checkpoint;
    return is_there(newest) || is_there(previous_checkpoint(newest));
}

bool has_results(const std::filesystem::path& folder) {
    return is_there(folder / result_files::summary) || is_there(folder / result_files::history);
}

void remove_results(const std::filesystem::path& folder) {
    for (const char* file : result_files::all) std::filesystem::remove(folder / file);
    std::filesystem::remove(previous_checkpoint(folder / result_files::checkpoint));
}

}  // namespace stria::coarse
