#include "app/results/run_tables.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria {
namespace {

using Rows = std::vector<std::size_t>;

TEST(RunTables, RowsOfNoTipCountAsThoseOfTheFirst) {
    const NumberTable table{.columns = {{"tip", {0.0, 1.0, NAN, 0.0}}}, .rows = 4};
    EXPECT_EQ(rows_of_tip(table, 0), (Rows{0, 2, 3}));
    EXPECT_EQ(rows_of_tip(table, 1), (Rows{1}));
    EXPECT_EQ(rows_of_tip({}, 0), Rows());
}

TEST(RunTables, RowsOfACrackGoAlongIt) {
    const NumberTable faces{
        .columns = {{"increment", {1.0, 2.0, 2.0, 2.0}}, {"crack", {0.0, 0.0, 1.0, 0.0}}, {"s", {0.5, 3.0, 1.0, 2.0}}},
        .rows = 4};
    EXPECT_EQ(rows_of_crack(faces, 0, 2.0), (Rows{3, 1}));
    EXPECT_EQ(rows_of_crack(faces, 1, 2.0), (Rows{2}));
    EXPECT_EQ(rows_of_crack(faces, 1, 1.0), Rows());
    EXPECT_EQ(values_of(faces, "s", {3, 1}), (std::vector<double>{2.0, 3.0}));
    EXPECT_TRUE(std::isnan(values_of(faces, "slip", {3}).at(0)));
}

}  // namespace
}  // namespace stria
