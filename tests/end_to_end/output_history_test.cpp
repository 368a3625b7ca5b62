// output.history = "cycles": rows at extremes of the load and after growth, with the same numbers; nothing else
// changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "common/io/number_table.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

constexpr const char* plate_with_history = R"(
units = "N-mm-MPa"
model = { plane = "stress" }
mesh = { specimen = "sent", width = 20.0, height = 40.0, size = 2.0 }
material = { young = 200e3, poisson = 0.3, yield_stress = 300.0, kinematic = [ { C = 4000.0 } ] }
crack = [ { points = [[0.0, 20.0], [8.0, 20.0]], contact = { friction = 0.0 } } ]
boundary = [ { on = "top", traction = [0.0, 1.0] }, { on = "bottom", traction = [0.0, -1.0] } ]
load = { blocks = [ { cycles = 3, max = 40.0, ratio = -0.3 } ] }
growth = { increment = 0.25 }
fine = { refine = 8 }
output = { faces = "cycles" }
)";

class OutputHistory : public testing::TestWithParam<const char*> {
protected:
    [[nodiscard]] std::filesystem::path run(const std::string& history) const {
        std::ofstream(folder / "case.toml") << plate_with_history;
        const std::filesystem::path out = folder / history;
        EXPECT_EQ(run_program("stria",
                              {"run", folder / "case.toml", "-o", out, "--mode", GetParam(), "--set",
                               "output.history=" + history},
                              folder / "log"),
                  0)
            << text_of(folder / "log");
        return out;
    }

    TemporaryFolder folder;
};

void expect_equal(double a, double b, const std::string& where) {
    EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << where << ": " << a << ", " << b;
}

TEST_P(OutputHistory, OfExtremesHasTheSameNumbers) {
    const std::filesystem::path all = run("all"), cycles = run("cycles");
    const NumberTable every = read_table(all / "history.csv"), few = read_table(cycles / "history.csv");
    ASSERT_EQ(few.rows, 1U + 3U * 5U) << "the ramp; then zero, minimum, zero, maximum and what growth releases";
    EXPECT_GT(every.rows, 2 * few.rows);
    for (std::size_t row = 0; row < few.rows; ++row) {
        const double increment = few["increment"][row];
        const auto same = std::ranges::find(every["increment"], increment) - every["increment"].begin();
        ASSERT_LT(same, std::ssize(every["increment"]));
        for (const auto& [name, column] : few.columns)
            expect_equal(column[row], every[name][static_cast<std::size_t>(same)],
                         name + " of increment " + std::to_string(increment));
    }
    EXPECT_EQ(text_of(cycles / "faces.csv"), text_of(all / "faces.csv"));
    const NumberTable a = read_table(all / "cycles.csv"), b = read_table(cycles / "cycles.csv");
    ASSERT_EQ(a.rows, b.rows);
    for (const auto& [name, column] : a.columns)
        for (std::size_t row = 0; row < a.rows && name != "wall_s"; ++row)
            expect_equal(column[row], b[name][row], name + " of a cycle");
}

// Loads that lag lift K where no row is: J there is looked at all the same. It was 1.34 for 1.74.
TEST(OutputHistoryOfLoadsThatLag, HasTheSameExtremes) {
    const TemporaryFolder folder;
    std::ofstream(folder / "case.toml") << R"(
units = "N-mm-MPa"
mesh = { specimen = "sent", width = 20.0, height = 40.0, size = 1.0 }
material = { young = 200e3, poisson = 0.3, yield_stress = 400.0 }
crack = [ { points = [[0.0, 20.0], [6.0, 20.0]], contact = {} } ]
boundary = [ { on = "top", traction = [0.0, 1.0] }, { on = "top", case = "side", traction = [0.0, 1.0] },
             { on = "bottom", displacement = [0.0, 0.0] } ]
load_case = [ { name = "side", factor = 1.0, phase = 90.0 } ]
load = { steps = 12, blocks = [ { cycles = 2, max = 50.0, ratio = 0.0 } ] }
)";
    std::vector<double> J_max;
    for (const std::string history : {"all", "cycles"}) {
        ASSERT_EQ(run_program("stria",
                              {"run", folder / "case.toml", "-o", folder / history, "--mode", "inprocess", "--set",
                               "output.history=" + history},
                              folder / "log"),
                  0)
            << text_of(folder / "log");
        J_max.push_back(read_table(folder / (history + "/cycles.csv"))["J_max"].back());
    }
    EXPECT_GT(J_max[0], 0.0);
    EXPECT_EQ(J_max[1], J_max[0]);
}

INSTANTIATE_TEST_SUITE_P(Modes, OutputHistory, testing::Values("inprocess", "mpi", "monolithic"),
                         [](const auto& mode) { return mode.param; });

}  // namespace
}  // namespace stria::test
