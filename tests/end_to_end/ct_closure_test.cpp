// cases/ct-closure on larger elements: what a growing crack leaves in cycles.csv.
#include <gtest/gtest.h>

#include <cmath>

#include "common/io/number_table.hpp"
#include "tests/support/folders.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

const std::string shipped = std::string(test::source_folder) + "/cases/ct-closure/case.toml";

NumberTable cycles_of(const TemporaryFolder& folder, std::vector<std::string> settings) {
    std::vector<std::string> words{"run",   shipped,         "-o",    folder / "out", "--quiet",
                                   "--set", "mesh.size=3.2", "--set", "load.steps=12"};
    for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
    EXPECT_EQ(run_program("stria", words, folder / "log"), 0) << text_of(folder / "log");
    return read_table(folder / "out/cycles.csv");
}

TEST(CtClosure, GrowsAndMeasuresItsOpeningLoads) {
    const TemporaryFolder folder;
    const NumberTable cycles =
        cycles_of(folder, {"model.plane=\"stress\"", "load.blocks.0.cycles=6", "growth.increment=0.1"});
    const auto &a = cycles["a"], &K_max = cycles["K_max"], &K_min = cycles["K_min"], &K_op = cycles["K_op"],
               &K_cl = cycles["K_cl"], &U = cycles["U"];
    ASSERT_EQ(a.size(), 6U);
    for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_NEAR(a[k], 25.0 + 0.1 * static_cast<double>(k), 1e-9);
        EXPECT_GE(K_op[k], K_min[k]);
        EXPECT_LT(K_op[k], K_max[k]);
        EXPECT_GE(K_cl[k], K_min[k]);
        EXPECT_NEAR(U[k], (K_max[k] - K_op[k]) / (K_max[k] - K_min[k]), 1e-12);
    }
    EXPECT_EQ(K_op.front(), K_min.front());  // no wake yet
    EXPECT_GT(K_op.back(), K_min.back() + 0.05 * K_max.back());
}

TEST(CtClosure, SaysNothingOfTheOpeningOfACrackThatStaysClosed) {
    const TemporaryFolder folder;
    const NumberTable cycles =
        cycles_of(folder, {"load.blocks=[{cycles=2, max=-100.0, min=-400.0}]", "growth.every=5"});
    for (const char* column : {"K_op", "K_cl", "U", "dK_eff"})
        for (const double value : cycles[column]) EXPECT_TRUE(std::isnan(value)) << column;
}

}  // namespace
}  // namespace stria::test
