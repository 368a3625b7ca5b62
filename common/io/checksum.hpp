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

/// FNV-1a, of bytes or of whole numbers. No change of a single one keeps it: each step is one to one in the state and
/// in the number.
class Checksum {
public:
    void add(std::uint64_t number) { value_ = (value_ ^ number) * 1099511628211ULL; }
    void add(std::string_view bytes) {
        for (const char byte : bytes) add(std::uint64_t{static_cast<unsigned char>(byte)});
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037ULL;
};

[[nodiscard]] inline std::uint64_t checksum(std::string_view bytes) {
    Checksum sum;
    sum.add(bytes);
    return sum.value();
}

/// Of all that is in the file, as 16 digits; of a file that cannot be read as of an empty one.
[[nodiscard]] inline std::string checksum_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    return fmt::format("{:016x}", checksum(bytes));
}

}  // namespace stria
