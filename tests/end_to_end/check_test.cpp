// `stria check`: what it says of K, and how far that is from converged.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>

#include "common/index.hpp"
#include "common/io/number_table.hpp"
#include "tests/support/folders.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

constexpr const char* plate_of_elements = R"(
units = "N-mm-MPa"
mesh = {{ specimen = "plate", width = 20.0, height = 40.0, size = {} }}
material = {{ young = 200e3, poisson = 0.3, yield_stress = 300.0 }}
crack = [ {{ points = [[0.0, 20.1], [5.0, 20.1]] }} ]
boundary = [ {{ on = "top", traction = [0.0, 1.0] }}, {{ on = "bottom", traction = [0.0, -1.0] }} ]
load = {{ blocks = [ {{ cycles = 1, max = 10.0, ratio = 0.0 }} ] }}
)";

class Check : public testing::Test {
protected:
    std::string said_of(double size) {
        std::ofstream(folder / "case.toml") << fmt::format(plate_of_elements, size);
        EXPECT_EQ(run_program("stria", {"check", folder / "case.toml"}, folder / "log"), 0);
        return text_of(folder / "log");
    }

    TemporaryFolder folder;
};

TEST_F(Check, SaysHowFarKIsFromConverged) {
    const std::string changes = "on elements half as large K_I = ", warns = "# warning: tip 0: K changes by ";
    const std::string coarse = said_of(3.0), fine = said_of(0.25);
    EXPECT_NE(coarse.find("# tip 0: K_I = "), std::string::npos) << coarse;
    EXPECT_NE(coarse.find(changes), std::string::npos) << coarse;
    EXPECT_NE(coarse.find(warns), std::string::npos) << coarse;
    EXPECT_NE(fine.find(changes), std::string::npos) << fine;
    EXPECT_EQ(fine.find(warns), std::string::npos) << fine;
}

// Elements half as large take four times what the body does, which alone was announced.
TEST_F(Check, SaysBeforeItHalvesElementsWhatThatTakes) {
    const std::string said = said_of(1.25),
                      announced = "# estimate of the elastic body on elements half as large: about ";
    ASSERT_NE(said.find(announced), std::string::npos) << said;
    EXPECT_LT(said.find(announced), said.find("# tip 0: K_I = "));
}

// A force in N on the whole of a thick body would give a K that many times too large.
TEST_F(Check, SaysThatThicknessChangesNothing) {
    const std::string warns = "# warning: model.thickness = 25: loads and results are per mm";
    EXPECT_EQ(said_of(1.25).find("model.thickness = "), std::string::npos);
    ASSERT_EQ(run_program("stria", {"check", folder / "case.toml", "--set", "model.thickness=25"}, folder / "log"), 0);
    EXPECT_NE(text_of(folder / "log").find(warns), std::string::npos) << text_of(folder / "log");
}

TEST_F(Check, SaysThatClosureIsLookedAtBesideTheFaces) {
    const std::string warns =
        "# warning: tip 0: closure is looked at 6 mm behind it, and its faces that may touch end after 5 mm";
    (void)said_of(1.25);
    ASSERT_EQ(run_program("stria",
                          {"check", folder / "case.toml", "--set", "crack.0.contact={}", "--set", "closure.distance=6"},
                          folder / "log"),
              0);
    EXPECT_NE(text_of(folder / "log").find(warns), std::string::npos) << text_of(folder / "log");
}

// Of a crack that is hardly opened and turns at once the default distance of closure was a ten thousandth of what its K
// asks for behind the turn, and advice went by that.
TEST_F(Check, SaysWhatKIsBehindATurn) {
    (void)said_of(1.25);
    const auto said_with = [&](const char* tip) {
        EXPECT_EQ(run_program("stria",
                              {"check", folder / "case.toml", "--set", "growth.increment=0.5", "--set",
                               std::string("crack.0.points=[[0.0,20.1],") + tip + "]"},
                              folder / "log"),
                  0);
        return text_of(folder / "log");
    };
    const std::string turns = "as it grows it turns sharply at first: K_I = ";
    const std::string straight = said_with("[5.0,20.1]"), steep = said_with("[3.0,28.0]");
    EXPECT_EQ(straight.find(turns), std::string::npos) << straight;
    EXPECT_NE(steep.find(turns), std::string::npos) << steep;
}

// A crack of 45 degrees turns with its first growth: by elements of about 1.25 mm.
TEST_F(Check, SaysWhereAFirstGrowthTurnsByTooLittleForJ) {
    const std::string warns = "# warning: tip 0 turns sharply and grows by 3 mm, 2.4 elements of 1.25 mm: its J";
    (void)said_of(1.25);
    const auto said_with = [&](const char* growth) {
        EXPECT_EQ(run_program("stria",
                              {"check", folder / "case.toml", "--set", "crack.0.points=[[0.0,20.1],[5.1,25.2]]",
                               "--set", growth},
                              folder / "log"),
                  0);
        return text_of(folder / "log");
    };
    const std::string brief = said_with("growth={law='prescribed',increment=3.0}");
    EXPECT_NE(brief.find(warns), std::string::npos) << brief;
    EXPECT_EQ(said_with("growth={law='prescribed',increment=5.2}").find("turns sharply and grows"), std::string::npos);
    EXPECT_EQ(said_with("growth={law='prescribed',increment=3.0,direction='straight'}").find("turns sharply and grows"),
              std::string::npos);
}

// A weld that has shrunk opens and shears the crack at its toe.
TEST_F(Check, SaysTheKThatTheRunReaches) {
    const std::string joint = std::string(source_folder) + "/cases/t-joint/case.toml";
    ASSERT_EQ(run_program("stria", {"check", joint}, folder / "log"), 0);
    ASSERT_EQ(run_program("stria",
                          {"run", joint, "-o", folder / "out", "--mode", "inprocess", "--no-report", "--set",
                           "load.blocks.0.cycles=1", "--set", "output.fields=none"},
                          folder / "run.log"),
              0);
    const NumberTable history = read_table(folder / "out/history.csv");
    const auto most = std::ranges::max_element(history["load_factor"]) - history["load_factor"].begin();
    const double K_I = history["K_I"].at(at(most)), K_II = history["K_II"].at(at(most));
    EXPECT_GT(std::abs(K_II), 0.3 * K_I);
    const std::string said = text_of(folder / "log");
    EXPECT_NE(said.find(fmt::format("K_I = {:.5g}, K_II = {:.5g} MPa", K_I, K_II)), std::string::npos) << said;
}

}  // namespace
}  // namespace stria::test
