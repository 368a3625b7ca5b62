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
    std::string output = folder / "out";
};

// In process: a limit on the size of files would hit the shared memory of mpirun's own daemon as well.
TEST_F(ExitCode, OfAFullDisk) {
    const SmallDisk disk(16384);
    EXPECT_EQ(run({"--mode", "inprocess"}), 5) << said();
    EXPECT_TRUE(says(": cannot be written: File too large")) << said();
    EXPECT_FALSE(std::filesystem::exists(output + "/summary.json"));
}

TEST_F(ExitCode, NamesAFolderThatCannotBeMade) {
    std::ofstream(folder / "file") << "no folder";
    output = folder / "file/out";
    EXPECT_EQ(run({"--mode", "inprocess"}), 5) << said();
    EXPECT_TRUE(says("file/out: the folder of results cannot be made or written to")) << said();
}

}  // namespace
}  // namespace stria::test
