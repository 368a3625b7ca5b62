// A run in whose increments work is lost says so: a wheel rolls over a rough crack in few positions.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "common/io/number_table.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

constexpr const char* rolling_wheel = R"(
units = "N-mm-MPa"
mesh = { specimen = "plate", width = 40.0, height = 20.0, size = 2.0, grading = [
    { at = [[20.433, 19.75]], size = 0.2, outer_size = 0.2, radius = 0.8, growth = 0.4 } ] }
material = { young = 200e3, poisson = 0.3 }
crack = [ { points = [[20.0, 20.0], [20.866025404, 19.5]], contact = { friction = 0.1 } } ]
boundary = [
    { on = "bottom", displacement = [0.0, 0.0] },
    { on = "top", origin = [20.0, 20.0], travelling = { p0 = 100.0, half_width = 1.0, from = -8.0, to = 8.0 } } ]
load = { blocks = [ { cycles = 1, max = 0.0, min = -1.0 } ] }
)";

// By 96 positions friction takes 0.0016 N; by 8 of them 0.0007, and nobody said so.
TEST(OpenWorkBalance, IsSaidWhereItIsOpenBesideWhatFrictionTakes) {
    const TemporaryFolder folder;
    std::ofstream(folder / "case.toml") << rolling_wheel;
    const auto friction = [&](const std::string& steps) {
        EXPECT_EQ(run_program("stria",
                              {"run", folder / "case.toml", "-o", folder / "out", "--mode", "inprocess", "--force",
                               "--set", "load.steps=" + steps},
                              folder / "log"),
                  0)
            << text_of(folder / "log");
        return read_table(folder / "out/history.csv")["frictional_dissipation"].back();
    };
    const auto says = [&](const std::string& file) {
        return text_of(folder / file).find("the work balance is open by 0.") != std::string::npos;
    };
    const double coarse = friction("8");
    for (const char* file : {"log", "out/summary.json", "out/report.html"}) EXPECT_TRUE(says(file)) << file;
    const double fine = friction("96");
    for (const char* file : {"log", "out/summary.json", "out/report.html"}) EXPECT_FALSE(says(file)) << file;
    EXPECT_LT(coarse, 0.6 * fine);
}

}  // namespace
}  // namespace stria::test
