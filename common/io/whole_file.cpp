#include "common/io/whole_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "common/io/file_failure.hpp"

namespace stria {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) { throw FileFailure::of_writing(path, error); }

}  // namespace

// Only what is on the disk before the rename survives a power cut after it.
void sync_file(const std::filesystem::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) fail(path, errno);
    const int result = ::fsync(descriptor);
    const int error = errno;
    ::close(descriptor);
    if (result != 0 && error != EINVAL) fail(path, error);  // EINVAL: a file system without sync
}

void write_whole(const std::filesystem::path& path, const std::function<void(const std::filesystem::path&)>& write) {
    std::filesystem::path temporary = path;
    temporary += ".part";
    try {
        write(temporary);
        sync_file(temporary);
        if (std::rename(temporary.c_str(), path.c_str()) != 0) fail(path, errno);
    } catch (...) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw;
    }
    sync_file(path.has_parent_path() ? path.parent_path() : ".");
}

void write_whole_texts(const std::filesystem::path& path, std::initializer_list<std::string_view> texts,
                       const std::filesystem::path& earlier) {
    write_whole(path, [&](const std::filesystem::path& temporary) {
        errno = 0;
        std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
        for (const std::string_view text : texts) file.write(text.data(), static_cast<std::streamsize>(text.size()));
        file.flush();
        if (!file) fail(path, errno);
        if (earlier.empty() || !std::filesystem::exists(path)) return;
        sync_file(temporary);
        if (std::rename(path.c_str(), earlier.c_str()) != 0) fail(earlier, errno);
    });
}

void write_whole_text(const std::filesystem::path& path, std::string_view text) { write_whole_texts(path, {text}); }

}  // namespace stria
