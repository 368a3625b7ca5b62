#include "app/process/writable_folder.hpp"

#include "common/io/file_failure.hpp"

#include <cerrno>
#include <fmt/format.h>
#include <system_error>
#include <unistd.h>

namespace stria {

void make_writable_folder(const std::filesystem::path& folder) {
    std::error_code problem, unreachable;
    std::filesystem::create_directories(folder, problem);
    if (!std::filesystem::is_directory(folder, unreachable)) {
        if (!problem) problem = std::make_error_code(std::errc::not_a_directory);
        throw FileFailure(fmt::format("{}: the folder cannot be made: {}", folder.string(), problem.message()));
    }
    if (access(folder.c_str(), W_OK) != 0) throw FileFailure::of_writing(folder, errno);
}

}  // namespace stria
