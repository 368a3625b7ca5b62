// How runs end that cannot go well: the exit code of the README and one line that says why.
#include <gtest/gtest.h>

#include "tests/support/program.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/small_disk.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

using Words = std::vector<std::string>;

const Words quick{mesh_at_tip(0.3), "mesh.size=10.0", "load.blocks=[{cycles=1, max=50.0, ratio=-1.0}]", "load.steps=4"};

class ExitCode : public testing::Test {
protected:
    int run(const Words& more, const Words& settings = quick) {
        Words words{"run", shipped_sent, "-o", output};
        for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
        words.insert(words.end(), more.begin(), more.end());
        return run_program("stria", words, folder / "log");
    }
    [[nodiscard]] std::string said() const { return text_of(folder / "log"); }
    [[nodiscard]] bool says(const std::string& text) const { return said().find(text) != std::string::npos; }

    const TemporaryFolder folder;
    const std::string output = folder / "out";
};

class FullDisk : public ExitCode, public testing::WithParamInterface<const char*> {};

TEST_P(FullDisk, EndsARunInOrder) {
    const SmallDisk disk(16384);
    EXPECT_EQ(run({"--mode", GetParam()}), 5) << said();
    EXPECT_TRUE(says(": cannot be written: File too large")) << said();
    EXPECT_FALSE(std::filesystem::exists(output + "/summary.json"));
}

INSTANTIATE_TEST_SUITE_P(Mode, FullDisk, testing::Values("mpi", "inprocess"),
                         [](const auto& test) { return std::string(test.param); });

TEST_F(ExitCode, NamesAFolderThatCannotBeMade) {
    std::ofstream(folder / "file") << "no folder";
    EXPECT_EQ(run({"--mode", "inprocess", "-o", folder / "file/out"}), 5);
    EXPECT_TRUE(says("file/out: the folder of results cannot be made or written to")) << said();
}

}  // namespace
}  // namespace stria::test
