// HDF5 files return what was written.
#include "common/io/hdf5.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/temporary_folder.hpp"

namespace stria {
namespace {

class Hdf5File : public testing::Test {
protected:
    const test::TemporaryFolder folder;
};

TEST_F(Hdf5File, ReturnsWhatWasWritten) {
    const std::vector<double> numbers{1.5, -2.0, 1e300, 0.1, 5.0, 6.0};
    hdf5::write_file(folder / "f.h5", [&](hdf5::Group& root) {
        hdf5::Group group = root.create_group("g");
        group.write<double>("numbers", numbers, {3, 2});
        group.write<std::int32_t>("empty", std::vector<std::int32_t>{});
        group.write<std::uint64_t>("large", std::vector{std::numeric_limits<std::uint64_t>::max()});
        group.write<std::int8_t>("small", std::vector<std::int8_t>{-1, 0, 1});
        group.write_attribute<std::int64_t>("two", std::vector<std::int64_t>{1, 2});
        group.write_text("text", "hello");
        group.write_text("nothing", "");
        EXPECT_THROW(group.write<double>("wrong", numbers, {4, 2}), std::runtime_error);
    });
    const hdf5::Group group = hdf5::read_file(folder / "f.h5").group("g");  // keeps the file open
    EXPECT_EQ(group.read<double>("numbers"), numbers);
    EXPECT_EQ(group.shape("numbers"), (std::vector<std::size_t>{3, 2}));
    EXPECT_TRUE(group.read<std::int32_t>("empty").empty());
    EXPECT_EQ(group.read<std::uint64_t>("large").front(), std::numeric_limits<std::uint64_t>::max());
    EXPECT_EQ(group.read<std::int8_t>("small"), (std::vector<std::int8_t>{-1, 0, 1}));
    EXPECT_EQ(group.read_attribute<std::int64_t>("two"), (std::vector<std::int64_t>{1, 2}));
    EXPECT_EQ(group.read_text("text"), "hello");
    EXPECT_EQ(group.read_text("nothing"), "");
    EXPECT_TRUE(group.contains("numbers"));
    EXPECT_FALSE(group.contains("absent"));
    EXPECT_THROW(static_cast<void>(group.read<double>("absent")), std::runtime_error);
    EXPECT_THROW(hdf5::read_file(folder / "absent.h5"), std::runtime_error);
}

}  // namespace
}  // namespace stria
