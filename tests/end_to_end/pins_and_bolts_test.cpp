// What presses on holes and washers, in runs: the pin of cases/lug, and a bolt that is tightened across a crack.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "common/io/number_table.hpp"
#include "tests/end_to_end/figures.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

class PinsAndBolts : public testing::Test {
protected:
    /// Rows of its cycles and increments, once it has run.
    void run(const std::string& case_file, std::vector<std::string> more) {
        more.insert(more.begin(), {"run", case_file, "-o", folder / "out", "--force", "--mode", "inprocess",
                                   "--no-report", "--set", "output.fields=none"});
        ASSERT_EQ(run_program("stria", more, folder / "log"), 0) << text_of(folder / "log");
        cycles = read_table(folder / "out/cycles.csv");
        history = read_table(folder / "out/history.csv");
    }

    TemporaryFolder folder;
    NumberTable cycles, history;
};

const std::string lug = std::string(source_folder) + "/cases/lug/case.toml";

TEST_F(PinsAndBolts, ALugIsPulledByTheCosineOfItsPin) {
    run(lug, {});
    const double resultant = 0.5 * std::numbers::pi * 15.0 * 40.0;  // pressure times radius times pi / 2
    EXPECT_NEAR(history["load"].back(), resultant, 1e-3 * resultant);
    double released = 0.0;
    for (std::size_t row = 0; row < cycles.rows; ++row) {
        const std::vector<double>&a = cycles["a"], &K = cycles["K_max"];
        if (row > 0) released += 0.5 * (K[row - 1] * K[row - 1] + K[row] * K[row]) * (a[row] - a[row - 1]);
        if (a[row] != std::round(a[row]) && std::abs(a[row] - std::round(a[row])) > 1e-9) continue;
        const auto length = static_cast<int>(std::lround(a[row]));
        if (length != 1 && length != 2 && length != 4 && length != 8) continue;
        const std::vector<double> figures = figures_of("lug", std::to_string(length));
        EXPECT_NEAR(K[row], figures.at(0), 0.006) << length;  // to the digits that it gives
        EXPECT_NEAR(cycles["K_min"][row], figures.at(1), 0.006) << length;
        EXPECT_NEAR(cycles["N"][row], figures.at(2), 1.0) << length;
    }
    // What the loads have done and the body does not store went into the crack: the integral of K_I^2 / E'.
    released /= 200e3 / (1.0 - 0.3 * 0.3);
    EXPECT_NEAR(history["external_work"].back() - history["stored_energy"].back(), released, 5e-3 * released);
}

TEST_F(PinsAndBolts, TheFitOfThePinShiftsTheCyclesOfTheLug) {
    // Along one way: what the fit adds to K_II bends it.
    run(lug, {"--set", "growth.until=2", "--set", "growth.direction=straight"});
    const NumberTable tight = cycles;
    run(lug, {"--set", "growth.until=2", "--set", "growth.direction=straight", "--set", "load_case.0.constant=0"});
    ASSERT_EQ(cycles.rows, tight.rows);
    for (std::size_t row = 0; row < cycles.rows; ++row) {
        EXPECT_NEAR(cycles["K_min"][row], 0.0, 1e-9);
        EXPECT_GT(tight["K_min"][row], 40.0);
        EXPECT_NEAR(tight["K_max"][row] - tight["K_min"][row], cycles["K_max"][row], 1e-9 * cycles["K_max"][row]);
    }
}

// K_1(a) of each load alone, in a table and in the page, also where the run goes on from a checkpoint.
TEST_F(PinsAndBolts, TheLoadsOfALugHaveTheirOwnKAtEachLength) {
    run(lug, {"--set", "growth.until=2"});
    const NumberTable alone = read_table(folder / "out/load-cases.csv");
    ASSERT_EQ(alone.rows, cycles.rows);
    for (std::size_t row = 0; row < alone.rows; ++row) {
        EXPECT_EQ(alone["a"][row], cycles["a"][row]);
        EXPECT_NEAR(20.0 * alone["K_I_fit"][row], cycles["K_min"][row], 1e-9 * cycles["K_max"][row]);
        EXPECT_NEAR(40.0 * alone["K_I"][row] + 20.0 * alone["K_I_fit"][row], cycles["K_max"][row],
                    1e-9 * cycles["K_max"][row]);
        EXPECT_NE(alone["K_II_fit"][row], 0.0);
    }
    const std::string whole = text_of(folder / "out/load-cases.csv");
    run(lug, {"--set", "growth.until=2", "--set", "load.blocks.0.cycles=2"});
    EXPECT_EQ(read_table(folder / "out/load-cases.csv").rows, 2U);
    ASSERT_EQ(run_program("stria",
                          {"run", lug, "-o", folder / "out", "--resume", "--mode", "inprocess", "--set",
                           "growth.until=2", "--set", "output.fields=none"},
                          folder / "log"),
              0)
        << text_of(folder / "log");
    EXPECT_EQ(text_of(folder / "out/load-cases.csv"), whole);
    EXPECT_NE(text_of(folder / "out/report.html").find("load-cases-tip-0.csv"), std::string::npos);
}

// Two forces on washers, above and below an edge crack, are there first; the plate is then pulled in cycles.
constexpr const char* bolted_plate = R"(
units = "N-mm-MPa"
mesh = { specimen = "sent", width = 40.0, height = 80.0, size = 2.0 }
material = { young = 200e3, poisson = 0.3, yield_stress = 1e6 }
crack = [ { points = [[0.0, 40.0], [15.0, 40.0]], contact = { friction = 0.3 } } ]
load_case = [ { name = "bolt", constant = 500.0 } ]
boundary = [
  { on = "top", traction = [0.0, 1.0] }, { on = "bottom", traction = [0.0, -1.0] },
  { on = "point", at = [6.0, 50.0], force = [0.0, -1.0], case = "bolt" },
  { on = "point", at = [6.0, 30.0], force = [0.0, 1.0], case = "bolt" } ]
load = { steps = 16, blocks = [ { cycles = 2, max = 60.0, ratio = 0.0 } ] }
fine = { radius = 4.0 }
)";

TEST_F(PinsAndBolts, ABoltIsTightenedBeforeTheCyclesAndKeepsTheCrackShut) {
    std::ofstream(folder / "case.toml") << bolted_plate;
    run(folder / "case.toml", {"--set", "load_case.0.constant=0"});
    const double pulled = cycles["K_max"].back();
    EXPECT_LT(cycles["K_op"].back(), 1e-6 * pulled);
    // Loosened so far that it spreads the crack: open all the time, and so what a bolt does to K_I.
    run(folder / "case.toml", {"--set", "load_case.0.constant=-500"});
    const double bolt = cycles["K_max"].back() - pulled;
    EXPECT_GT(bolt, 0.05 * pulled);
    run(folder / "case.toml", {});
    EXPECT_NEAR(cycles["K_max"].back(), pulled - bolt, 1e-6 * pulled);
    EXPECT_GT(cycles["K_op"].back(), 0.05 * pulled);
    EXPECT_EQ(history["contact_length"].back(), 0.0);  // at the largest load
    EXPECT_GT(*std::ranges::max_element(history["contact_length"]), 2.0);
    EXPECT_EQ(history["load_factor"][0], 0.0);
    EXPECT_GT(history["contact_length"][0], 0.0);  // the bolt comes first
}

}  // namespace
}  // namespace stria::test
