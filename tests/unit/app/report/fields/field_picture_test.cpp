#include "app/report/fields/field_picture.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "coarse/fields/vtk_files.hpp"
#include "tests/support/counted_words.hpp"
#include "tests/support/opened_pair.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::report {
namespace {

using test::count;
using test::opened_pair;

TEST(FieldPicture, DrawsWhatHasFlowedWithTheCrackOpen) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "fields");
    coarse::write_vtkhdf(folder / "fields/step_00001.hdf", opened_pair(0.0));
    coarse::write_vtkhdf(folder / "fields/step_00002.hdf", opened_pair(0.02));
    std::ofstream(folder / "history.csv") << "increment,cycle,load_factor,tip,a\n1,7,50,0,1\n";
    const std::vector<std::string> charts = field_picture(read_run(folder / "")).charts;
    ASSERT_EQ(charts.size(), 2);
    EXPECT_EQ(charts[0], "");  // nothing has flowed
    EXPECT_EQ(count(charts[1], "<title>Cycle 7, load factor 50, displacement x 50</title>"), 1);
    EXPECT_EQ(count(charts[1], "<path class=\"l5\""), 1);
    EXPECT_EQ(count(charts[1], "<path class=\"l0\""), 1);
    EXPECT_EQ(count(charts[1], "&gt; 0.005"), 1);  // 30 % of 0.02, rounded down
}

}  // namespace
}  // namespace stria::report
