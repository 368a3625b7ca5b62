// A case as text, and what is said of it where a passage reads otherwise.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"
#include "tests/support/refusal.hpp"

namespace stria::test {

// Line numbers in the tests count from the `title`, line 1.
inline const std::string complete = R"(title = "a plate"
units = "N-mm-MPa"
[mesh]
specimen = "sent"
width = 50.0
height = 200
size = 5.0
grading = [ { at = [20.0, 100.0], size = 0.1, outer_size = 0.2, radius = 3.0 } ]
[material]
young = 200e3
poisson = 0.3
yield_stress = 300.0
kinematic = [ { C = 4000.0 } ]
[[crack]]
points = [[0.0, 100.0], [20.0, 100.0]]
contact = { friction = 0.0 }
[[boundary]]
on = "top"
traction = [0.0, 1.0]
[[boundary]]
on = "point"
at = [25.0, 0.0]
displacement = ["free", 0.0]
[load]
blocks = [ { max = 50.0, ratio = -1.0 } ]
)";

class CaseFile : public testing::Test {
protected:
    void SetUp() override {
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        folder_ = std::filesystem::temp_directory_path() / ("stria-" + test + "-" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_ / "plate");
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    Case read(const std::string& text, const std::vector<std::string>& overrides = {}) {
        path_ = (folder_ / "plate" / "case.toml").string();
        std::ofstream(path_) << text;
        return read_case(path_, overrides);
    }

    /// The complaint about the text, without the folder in front.
    std::string complaint(const std::string& text, const std::vector<std::string>& overrides = {}) {
        const std::string said = refusal_of([&] { return read(text, overrides); });
        return said.starts_with(path_) ? said.substr(path_.size() - std::string("case.toml").size()) : said;
    }

    /// The complaint when one passage of the complete case reads otherwise.
    std::string complaint_about(const std::string& passage, const std::string& replacement) {
        std::string text = complete;
        const std::size_t at = text.find(passage);
        EXPECT_NE(at, std::string::npos) << passage;
        return complaint(text.replace(at, passage.size(), replacement));
    }

    std::filesystem::path folder_;
    std::string path_;
};

}  // namespace stria::test
