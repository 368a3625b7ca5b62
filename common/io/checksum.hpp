// Whether bytes are those of before.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace stria {

/// FNV-1a. No change of a single byte keeps it: each step is one to one in the state and in the byte.
[[nodiscard]] inline std::uint64_t checksum(std::string_view bytes) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
    return hash;
}

/// Of all that is in the file, as 16 digits; of a file that cannot be read as of an empty one.
[[nodiscard]] inline std::string checksum_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    return fmt::format("{:016x}", checksum(bytes));
}

}  // namespace stria
