// Values through an HDF5 file: every bit comes back, and what is missing is said.
#include "common/io/archive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "common/geometry/vec2.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {

enum class Colour { Red, Green };

struct Leaf {
    int number = 0;
    std::vector<double> values;
};

struct Span {
    double from = 0.0, to = 0.0;
};

struct Row {
    int cycle = 0;
    bool loads = false;
    Colour colour = Colour::Red;
    Span way;
};

struct Whole {
    bool flag = false;
    Colour colour = Colour::Red;
    std::uint64_t large = 0;
    double value = 0.0;
    std::string text;
    std::vector<char> marks;
    std::vector<std::byte> bytes;
    std::vector<std::int32_t> numbers;
    Eigen::VectorXd vector;
    std::vector<Eigen::VectorXd> vectors, none;
    std::vector<Leaf> leaves;
    std::vector<Row> rows, no_rows;
};

STRIA_MEMBERS(Leaf, number, values)
STRIA_MEMBERS(Span, from, to)
STRIA_MEMBERS(Row, cycle, loads, colour, way)
STRIA_MEMBERS(Whole, flag, colour, large, value, text, marks, bytes, numbers, vector, vectors, none, leaves, rows,
              no_rows)

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Archive, GivesBackEveryBit) {
    const TemporaryFolder folder;
    const Whole in{.flag = true,
                   .colour = Colour::Green,
                   .large = std::numeric_limits<std::uint64_t>::max(),
                   .value = -0.0,
                   .text = "size = 0.1 # mm, 45°",
                   .marks = {0, 1, -1},
                   .bytes = {std::byte{0}, std::byte{255}},
                   .numbers = {-1, 1'000'000'000},
                   .vector = Eigen::Vector3d(0.1, 1e-320, -infinity),
                   .vectors = {Vec2(1.0, 2.0), Vec2(3.0, 4.0)},
                   .none = {},
                   .leaves = {{7, {0.5}}, {8, {}}},
                   .rows = {{1, true, Colour::Green, {0.1, -0.0}}, {2, false, Colour::Red, {1e-320, infinity}}},
                   .no_rows = {}};
    hdf5::write_file(folder / "file.h5", [&](hdf5::Group& root) { hdf5::Saver{root}("whole", in); });
    Whole out;
    out.none.resize(3);
    out.no_rows.resize(3);
    hdf5::Loader{hdf5::read_file(folder / "file.h5")}("whole", out);
    EXPECT_EQ(out.flag, in.flag);
    EXPECT_EQ(out.colour, in.colour);
    EXPECT_EQ(out.large, in.large);
    EXPECT_TRUE(std::signbit(out.value));
    EXPECT_EQ(out.text, in.text);
    EXPECT_EQ(out.marks, in.marks);
    EXPECT_EQ(out.bytes, in.bytes);
    EXPECT_EQ(out.numbers, in.numbers);
    EXPECT_EQ(out.vector, in.vector);
    EXPECT_EQ(out.vectors, in.vectors);
    EXPECT_TRUE(out.none.empty());
    ASSERT_EQ(out.leaves.size(), 2U);
    EXPECT_EQ(out.leaves[0].number, 7);
    EXPECT_EQ(out.leaves[0].values, in.leaves[0].values);
    EXPECT_TRUE(out.leaves[1].values.empty());
    ASSERT_EQ(out.rows.size(), 2U);
    EXPECT_EQ(out.rows[1].cycle, 2);
    EXPECT_TRUE(out.rows[0].loads);
    EXPECT_FALSE(out.rows[1].loads);
    EXPECT_EQ(out.rows[0].colour, Colour::Green);
    EXPECT_TRUE(std::signbit(out.rows[0].way.to));
    EXPECT_EQ(out.rows[1].way.from, 1e-320);
    EXPECT_EQ(out.rows[1].way.to, infinity);
    EXPECT_TRUE(out.no_rows.empty());
}

TEST(Archive, KeepsALongListOfRecordsInOneTable) {
    const TemporaryFolder folder;
    const std::vector<Row> rows(10'000, {.cycle = 1, .loads = true, .colour = Colour::Green, .way = {0.1, 0.2}});
    hdf5::write_file(folder / "file.h5", [&](hdf5::Group& root) { hdf5::Saver{root}("rows", rows); });
    EXPECT_LT(std::filesystem::file_size(folder / "file.h5"), 10'000 * 32);  // as groups 400 bytes and more each
    std::vector<Row> found;
    hdf5::Loader{hdf5::read_file(folder / "file.h5")}("rows", found);
    ASSERT_EQ(found.size(), rows.size());
    EXPECT_EQ(found.back().way.to, 0.2);
}

TEST(Archive, NamesWhatIsMissing) {
    const TemporaryFolder folder;
    hdf5::write_file(folder / "file.h5", [&](hdf5::Group& root) { hdf5::Saver{root}("leaf", Leaf()); });
    hdf5::Loader load(hdf5::read_file(folder / "file.h5"));
    Whole out;
    try {
        load("leaf", out);
        FAIL() << "a leaf is no whole";
    } catch (const std::runtime_error& problem) {
        EXPECT_NE(std::string(problem.what()).find("flag"), std::string::npos);
    }
}

}  // namespace
}  // namespace stria::test
