// A folder of its own for a test, or for what a suite of tests shares; removed with what is in it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>

namespace stria::test {

class TemporaryFolder {
public:
    TemporaryFolder() {
        const auto& running = *testing::UnitTest::GetInstance();
        const auto* test = running.current_test_info();
        std::string name = std::string(running.current_test_suite()->name()) + '.' + (test ? test->name() : "all") +
                           '.' + std::to_string(getpid());
        for (char& c : name) c = c == '/' ? '_' : c;
        path_ = std::filesystem::path(testing::TempDir()) / ("stria_" + name);
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }

private:
    std::filesystem::path path_;
};

inline std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace stria::test
