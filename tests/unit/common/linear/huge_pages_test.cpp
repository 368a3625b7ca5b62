#include "common/linear/huge_pages.hpp"

#include <gtest/gtest.h>
#include <suitesparse/SuiteSparse_config.h>

#include <cstdint>
#include <fstream>
#include <string>

namespace stria::test {
namespace {

/// Of the mapping of this process that holds an address: "hg" among them is the advice to take huge pages (proc(5)).
std::string flags_of_mapping(const void* address) {
    std::ifstream maps("/proc/self/smaps");
    const auto wanted = reinterpret_cast<std::uintptr_t>(address);
    bool inside = false;
    for (std::string line; std::getline(maps, line);) {
        std::size_t end_of_first = 0;
        const std::size_t dash = line.find('-');
        if (dash != std::string::npos && line.find(':') > dash && std::isxdigit(line[0]) != 0) {
            const auto first = std::stoull(line, &end_of_first, 16);
            if (end_of_first == dash)
                inside = first <= wanted && wanted < std::stoull(line.substr(dash + 1), nullptr, 16);
        }
        if (inside && line.starts_with("VmFlags:")) return line + " ";
    }
    return "";
}

TEST(HugePages, HoldTheLargeBlocksOfFactorsAlone) {
    const auto before = SuiteSparse_config;
    use_huge_pages();
    constexpr std::size_t megabyte = std::size_t{1} << 20U;
    for (const bool large : {true, false}) {
        const std::size_t size = large ? 50 * megabyte + 3 : megabyte / 2;
        auto* block = static_cast<char*>(SuiteSparse_malloc(1, size));
        ASSERT_NE(block, nullptr);
        block[0] = block[size - 1] = 'x';
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % (2 * megabyte) == 0, large);
        EXPECT_EQ(flags_of_mapping(block).find(" hg ") != std::string::npos, large);
        int ok = 0;
        block = static_cast<char*>(SuiteSparse_realloc(size + 1, size, 1, block, &ok));
        EXPECT_EQ(ok, 1);
        EXPECT_EQ(block[size - 1], 'x');
        SuiteSparse_free(block);
    }
    SuiteSparse_config = before;
}

}  // namespace
}  // namespace stria::test
