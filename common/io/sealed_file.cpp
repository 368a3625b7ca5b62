#include "common/io/sealed_file.hpp"

#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <string>

#include "common/io/checksum.hpp"
#include "common/io/file_failure.hpp"
#include "common/io/whole_file.hpp"

namespace stria {
namespace {

constexpr std::size_t block_size = 512;  // the smallest user block

std::string block_of(std::string_view content) {
    std::string block =
        fmt::format("FNV-1a of the {} bytes behind this block: {:016x}\n", content.size(), checksum(content));
    block.resize(block_size, '\0');
    return block;
}

}  // namespace

void write_sealed(const std::filesystem::path& path, std::string_view content, const std::filesystem::path& earlier) {
    write_whole_texts(path, {block_of(content), content}, earlier);
}

void check_seal(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileFailure(path.string() + ": cannot be read");
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const std::string_view whole = bytes;
    if (whole.size() <= block_size || whole.substr(0, block_size) != block_of(whole.substr(block_size)))
        throw FileFailure(path.string() + ": is damaged, its checksum is another one");
}

}  // namespace stria
