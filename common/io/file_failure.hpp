// A file that could not be written or read.
#pragma once

#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace stria {

/// The disk is full or read-only, or a file has vanished (exit code 5). The text names the file and the reason.
class FileFailure : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;

    /// `error`: errno.
    static FileFailure of_writing(const std::filesystem::path& path, int error) {
        return FileFailure(path.string() + ": cannot be written: " + std::strerror(error));
    }
};

}  // namespace stria
