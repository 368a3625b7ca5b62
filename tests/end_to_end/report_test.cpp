// `stria run` leaves a page, `stria report` makes it again, and the running number of cycles is where it is looked for.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "common/io/number_table.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

constexpr const char* growing_plate = R"(
title = "A plate that breaks"
units = "N-mm-MPa"
mesh = { specimen = "sent", width = 20.0, height = 40.0, size = 2.0 }
material = { young = 200e3, poisson = 0.3 }
crack = [ { points = [[0.0, 20.0], [5.0, 20.0]] } ]
boundary = [ { on = "top", traction = [0.0, 1.0] }, { on = "bottom", traction = [0.0, -1.0] } ]
load = { steps = 2, blocks = [ { cycles = 9, max = 50.0, ratio = 0.1 } ] }
growth = { law = "paris", C = 3e-13, m = 3.0, increment = 1.0, until = 8.0 }
output = { fields = "none" }
)";

class ReportOfARun : public testing::Test {
protected:
    int run(const std::vector<std::string>& more) {
        std::ofstream(folder / "case.toml") << growing_plate;
        std::vector<std::string> arguments = {"run", folder / "case.toml", "-o", folder / "out"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program("stria", arguments, folder / "log");
    }
    [[nodiscard]] std::string page() const { return text_of(folder / "out/report.html"); }
    [[nodiscard]] std::string said() const { return text_of(folder / "log"); }

    TemporaryFolder folder;
};

TEST_F(ReportOfARun, EndsWithTheLife) {
    ASSERT_EQ(run({}), 0) << said();
    const NumberTable cycles = read_table(folder / "out/cycles.csv");
    ASSERT_EQ(cycles.rows, 4);
    double N = 0.0;
    for (std::size_t row = 0; row < cycles.rows; ++row) {
        N += cycles["dN"][row];
        EXPECT_EQ(cycles["N"][row], N);
    }
    EXPECT_GT(N, 1000.0);
    EXPECT_NE(said().find(": life N = "), std::string::npos) << said();
    EXPECT_NE(page().find("<li>life<b>"), std::string::npos);
    EXPECT_NE(page().find("<h1>A plate that breaks</h1>"), std::string::npos);
}

TEST_F(ReportOfARun, IsTheSameMadeAgain) {
    ASSERT_EQ(run({"--mode", "inprocess"}), 0) << said();
    const std::string first = page();
    ASSERT_GT(first.size(), 10000);
    std::filesystem::remove(folder / "out/report.html");
    ASSERT_EQ(run_program("stria", {"report", folder / "out"}, folder / "log"), 0) << said();
    EXPECT_EQ(page(), first);
    EXPECT_EQ(run_program("stria", {"report", folder / "nowhere"}, folder / "log"), 2);
    EXPECT_NE(said().find("holds no run"), std::string::npos) << said();
    std::ofstream(folder / "study.csv") << "variant\n";
    EXPECT_EQ(run_program("stria", {"report", folder / ""}, folder / "log"), 2);
    EXPECT_NE(said().find("holds a study: its page is study.html"), std::string::npos) << said();
    EXPECT_EQ(run_program("stria", {"run", folder / "case.toml", "-o", folder / ""}, folder / "log"), 2);
    EXPECT_NE(said().find("holds a study, and the tables of a run"), std::string::npos) << said();
    // Then it is the folder of a run, and nobody takes it for that of a study; nor does a study write among its tables.
    EXPECT_EQ(
        run_program("stria",
                    {"run", folder / "case.toml", "-o", folder / "", "--mode", "inprocess", "--no-report", "--force"},
                    folder / "log"),
        0)
        << said();
    EXPECT_FALSE(std::filesystem::exists(folder / "study.csv"));
    EXPECT_EQ(run_program("stria", {"study", folder / "case.toml", "-o", folder / "", "--over", "load.steps=2,4"},
                          folder / "log"),
              2);
    EXPECT_NE(said().find("holds a run, and the table of a study"), std::string::npos) << said();
}

TEST_F(ReportOfARun, IsMadeWhereTheNumbersFail) {
    ASSERT_EQ(run({"--set", "material.yield_stress=100", "--set", "solver.max_iterations=2", "--set",
                   "solver.max_cuts=0", "--set", "load.steps=8"}),
              3)
        << said();
    EXPECT_NE(page().find("The run has failed"), std::string::npos);
}

TEST_F(ReportOfARun, IsMadeOfComponentsStartedByHand) {
    std::ofstream(folder / "case.toml") << growing_plate;
    ASSERT_EQ(run_program("stria-coarse", {folder / "case.toml", "-o", folder / "out"}, folder / "log"), 0) << said();
    EXPECT_NE(page().find("A plate that breaks"), std::string::npos);
}

TEST_F(ReportOfARun, IsLeftOutOnRequestAndMadeOfAnUnfinishedRun) {
    ASSERT_EQ(run({"--no-report"}), 0) << said();
    EXPECT_FALSE(std::filesystem::exists(folder / "out/report.html"));
    std::filesystem::remove(folder / "out/summary.json");
    ASSERT_EQ(run_program("stria", {"report", folder / "out"}, folder / "log"), 0) << said();
    EXPECT_NE(page().find("The run has not ended"), std::string::npos);
}

}  // namespace
}  // namespace stria::test
