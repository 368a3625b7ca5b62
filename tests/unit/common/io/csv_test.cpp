// Tables as their readers find them, after a checkpoint, a crash and a full disk too.
#include "common/io/csv.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "common/io/file_failure.hpp"
#include "tests/support/small_disk.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria {
namespace {

class CsvFile : public testing::Test {
protected:
    const test::TemporaryFolder folder;
};

TEST_F(CsvFile, WritesShortestNumbersAndEmptyCells) {
    CsvWriter csv(folder / "t.csv", {"n", "x", "name"});
    csv.row(std::vector<Cell>{std::int64_t{3}, 0.1, std::string("a \"b\", c")});
    csv.row(std::vector<Cell>{std::monostate{}, std::nan(""), std::string()});
    csv.row(std::vector<Cell>{std::int64_t{-1}, 1.0 / 3.0, std::string("end")});
    EXPECT_EQ(test::text_of(folder / "t.csv"),
              "n,x,name\n3,0.1,\"a \"\"b\"\", c\"\n,,\n-1,0.3333333333333333,end\n");  // before it closes
    EXPECT_EQ(csv.rows(), 3U);
    EXPECT_THROW(csv.row(std::vector<Cell>{1.0}), std::logic_error);
}

TEST_F(CsvFile, ContinuesAfterACheckpoint) {
    const std::vector<std::string> columns{"a", "b"};
    {
        CsvWriter csv(folder / "t.csv", columns);
        for (const double value : {1.0, 2.0, 3.0}) csv.row(std::vector<Cell>{value, -value});
    }
    CsvWriter csv(folder / "t.csv", columns, 2);
    csv.row(std::vector<Cell>{4.0, 5.5});
    EXPECT_EQ(test::text_of(folder / "t.csv"), "a,b\n1,-1\n2,-2\n4,5.5\n");
    EXPECT_THROW(CsvWriter(folder / "t.csv", columns, 9), std::runtime_error);
    EXPECT_THROW(CsvWriter(folder / "t.csv", {"a", "c"}, 1), std::runtime_error);
    EXPECT_EQ(test::text_of(folder / "t.csv"), "a,b\n1,-1\n2,-2\n4,5.5\n");
}

TEST_F(CsvFile, DropsALineThatACrashCutShort) {
    std::ofstream(folder / "t.csv") << "a\n1\n2";
    EXPECT_THROW(CsvWriter(folder / "t.csv", {"a"}, 2), std::runtime_error);
    const CsvWriter csv(folder / "t.csv", {"a"}, 1);
    EXPECT_EQ(test::text_of(folder / "t.csv"), "a\n1\n");
}

TEST_F(CsvFile, KeepsWholeRowsOnAFullDisk) {
    CsvWriter csv(folder / "t.csv", {"a"});
    const test::SmallDisk disk(10);
    csv.row(std::vector<Cell>{1.5});
    EXPECT_THROW(csv.row(std::vector<Cell>{0.123456789}), FileFailure);
    EXPECT_EQ(test::text_of(folder / "t.csv"), "a\n1.5\n");
}

}  // namespace
}  // namespace stria
