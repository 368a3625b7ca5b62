// Files on a disk that is full: a failure with the file's name, what was there before stays whole, and the program
// lives on.
#include "common/io/whole_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "common/error.hpp"
#include "common/io/file_failure.hpp"
#include "common/io/hdf5.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/small_disk.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria {
namespace {

class FullDisk : public testing::Test {
protected:
    template <class Write> static std::string complaint(Write write) {
        const test::SmallDisk disk(4096);
        return test::refusal_of<FileFailure>(write);
    }
    const test::TemporaryFolder folder;
    const std::string file = folder / "f";
};

TEST_F(FullDisk, LeavesTheTextBefore) {
    write_whole_text(file, "old");
    EXPECT_EQ(complaint([&] { write_whole_text(file, std::string(8192, 'x')); }),
              file + ": cannot be written: File too large");
    EXPECT_EQ(test::text_of(file), "old");
    EXPECT_FALSE(std::filesystem::exists(file + ".part"));
}

// The library's own files crash when a program ends that could not write them.
TEST_F(FullDisk, LeavesTheHdf5FileBefore) {
    const auto write = [&](std::size_t count) {
        hdf5::write_file(file,
                         [&](hdf5::Group& root) { root.write<double>("numbers", std::vector<double>(count, 1.0)); });
    };
    write(3);
    EXPECT_EQ(complaint([&] { write(3000); }), file + ": cannot be written: File too large");
    EXPECT_EQ(hdf5::read_file(file).read<double>("numbers").size(), 3U);
}

class WholeFile : public testing::Test {
protected:
    const test::TemporaryFolder folder;
};

TEST_F(WholeFile, KeepsTheOldOneWhenWritingFails) {
    write_whole_text(folder / "f", "old");
    EXPECT_THROW(write_whole(folder / "f",
                             [](const auto& temporary) {
                                 std::ofstream(temporary) << "half";
                                 throw NumericalFailure("stop");
                             }),
                 NumericalFailure);
    EXPECT_EQ(test::text_of(folder / "f"), "old");
    EXPECT_FALSE(std::filesystem::exists(folder / "f.part"));
    EXPECT_THROW(write_whole_text(folder / "no/f", "x"), FileFailure);
}

}  // namespace
}  // namespace stria
