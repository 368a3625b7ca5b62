#include "coarse/results/result_files.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "coarse/results/run_status.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::coarse {
namespace {

TEST(ResultFiles, OfAnEarlierRunGoAndOthersStay) {
    const test::TemporaryFolder folder;
    for (const char* file : result_files::all) std::ofstream(folder / file) << "old\n";
    for (const char* file : {"checkpoint.previous.h5", "report.html"}) std::ofstream(folder / file) << "old\n";
    std::ofstream(folder / "notes.txt") << "mine\n";
    EXPECT_TRUE(has_results(folder / ""));
    EXPECT_TRUE(has_checkpoint(folder / ""));
    remove_results(folder / "");
    EXPECT_FALSE(has_results(folder / ""));
    EXPECT_FALSE(has_checkpoint(folder / ""));
    const std::filesystem::directory_iterator left(folder / "");
    EXPECT_EQ(left->path().filename(), "notes.txt");
    EXPECT_EQ(std::distance(left, {}), 1);
}

TEST(ResultFiles, TheCheckpointBeforeTheLastOneServes) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "checkpoint.previous.h5") << "old\n";
    EXPECT_TRUE(has_checkpoint(folder / ""));
    EXPECT_FALSE(has_results(folder / ""));
    EXPECT_FALSE(has_checkpoint(folder / "nowhere"));
}

TEST(RunStatus, IsReadAsItIsWritten) {
    for (int k = 0; k <= static_cast<int>(RunStatus::Error); ++k) {
        const auto status = static_cast<RunStatus>(k);
        EXPECT_EQ(run_status(to_text(status)), status) << to_text(status);
    }
    EXPECT_EQ(to_text(RunStatus::NotRun), "not run");
    EXPECT_EQ(run_status(""), std::nullopt);
}

}  // namespace
}  // namespace stria::coarse
