// Load cases and distributed pressures in case files: what is read, written again, and refused.
#include "common/case/loads/load_case_checks.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"
#include "tests/support/load_cases.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria {
namespace {

// 17 lines.
const std::string plate = R"(units = "N-mm-MPa"
[mesh]
specimen = "sent"
width = 50.0
size = 5.0
[material]
young = 200e3
poisson = 0.3
[[crack]]
points = [[0.0, 100.0], [20.0, 100.0]]
[load]
blocks = [ { cycles = 3, max = 50.0, ratio = -1.0 } ]
[[boundary]]
on = "top"
traction = [0.0, 1.0]
[[boundary]]
on = "bottom"
)";
const std::string held = "displacement = [0.0, 0.0]\n";
const std::string dead = "[[boundary]]\non = \"top\"\ntraction = [0.0, 1.0]\ncase = \"dead\"\n";

class LoadCaseFile : public testing::Test {
protected:
    Case read(const std::string& text) {
        std::ofstream(folder / "case.toml") << text;
        return read_case(folder / "case.toml", {});
    }
    std::string complaint(const std::string& more) {
        const std::string said = test::refusal_of([&] { read(plate + held + more); });
        return said.substr(said.rfind('/') + 1);
    }
    test::TemporaryFolder folder;
};

TEST_F(LoadCaseFile, ReadsAndWritesThemAgain) {
    const Case input = read(plate + held + dead + R"([[load_case]]
name = "dead"
constant = 20.0
[[load_case]]
name = "shear"
factor = 0.5
phase = 90.0
path = "triangle"
[[load_case]]
name = "own"
blocks = [ { cycles = 1, at_max = 1.0, at_min = 2.0 }, { cycles = 2, at_max = 3.0, at_min = 0.0 } ]
[[boundary]]
on = "right"
pressure = 2.0
cosine = [1.0, 0.0]
centre = [40.0, 100.0]
case = "shear"
[[boundary]]
on = "right"
displacement = ["free", 0.1]
case = "own"
[[boundary]]
on = "left"
origin = [0.0, 100.0]
travelling = { p0 = 100.0, half_width = 2.0, friction = -0.1, from = -8.0, to = 8.0 }
)");
    ASSERT_EQ(input.load_cases.size(), 3U);
    EXPECT_EQ(input.load_cases[0], test::dead_load("dead", 20.0));
    EXPECT_EQ(input.load_cases[1].path, LagPath::Triangle);
    EXPECT_EQ(input.load_cases[2].blocks[1], (CaseBlock{2, 3.0, 0.0}));
    EXPECT_EQ(input.boundaries[5].travelling->friction, -0.1);
    EXPECT_FALSE(is_of_main_load(input.boundaries[5]));
    EXPECT_TRUE(is_of_main_load(input.boundaries[0]));
    Case again = read(resolved_toml(input));
    again.name = input.name;
    EXPECT_EQ(again, input);
}

TEST_F(LoadCaseFile, TakesColumnsOfTheSpectrum) {
    std::ofstream(folder / "s.csv") << "turning_point,shear\n0,0\n10,5\n5,3\n0,1\n20,-5\n-20,2\n";
    std::string text = plate + held + "[[load_case]]\nname = \"shear\"\n" + dead;
    text.replace(text.find("case = \"dead\""), 13, "case = \"shear\"");
    text.replace(text.find("blocks"), text.find("[[boundary]]") - text.find("blocks"), "spectrum = \"s.csv\"\n");
    const Case input = read(text);
    EXPECT_EQ(input.load.blocks, (std::vector<LoadBlock>{{1, 10.0, 0.0}, {1, 20.0, -20.0}}));
    EXPECT_EQ(input.load_cases[0].blocks, (std::vector<CaseBlock>{{1, 5.0, 1.0}, {1, -5.0, 2.0}}));
    std::ofstream(folder / "s.csv") << "turning_point,shear\n0,0\n10,5\n5,4\n0,1\n";
    EXPECT_THROW(read(text), CaseError);
    std::ofstream(folder / "s.csv") << "turning_point\n0\n10\n0\n";
    EXPECT_THROW(read(text), CaseError);
}

TEST_F(LoadCaseFile, RefusesNamesThatAreNone) {
    EXPECT_EQ(complaint(dead), "case.toml:22: boundary.2.case = \"dead\" is no load case: there is no [[load_case]]");
    EXPECT_EQ(complaint(dead + "[[load_case]]\nname = \"weight\"\nconstant = 1.0\n"),
              "case.toml:22: boundary.2.case = \"dead\" is no load case; there are \"weight\"");
    EXPECT_EQ(complaint("[[load_case]]\nname = \"dead\"\nconstant = 1.0\n"),
              "case.toml:19: load_case.0 loads nothing: no [[boundary]] has case = \"dead\"");
    EXPECT_EQ(complaint("[[load_case]]\nname = \"a, b\"\nconstant = 1.0\n"),
              "case.toml:20: load_case.0.name = \"a, b\" must be of letters, digits, _ and -: it names a column");
    const std::string twice = "[[load_case]]\nname = \"dead\"\nconstant = 1.0\n";
    EXPECT_EQ(complaint(dead + twice + twice),
              "case.toml:27: load_case.1.name = \"dead\" is the name of another load case");
}

TEST_F(LoadCaseFile, RefusesHistoriesThatAreNoneOrTwo) {
    const std::string name = dead + "[[load_case]]\nname = \"dead\"\n";
    EXPECT_EQ(complaint(name), "case.toml:23: load_case.0 needs constant, factor or blocks, or a column of "
                               "load.spectrum with its name");
    EXPECT_EQ(complaint(name + "constant = 1.0\nfactor = 2.0\n"),
              "case.toml:23: load_case.0 has more than one of constant, factor and blocks");
    EXPECT_EQ(complaint(name + "constant = 1.0\nphase = 20.0\n"),
              "case.toml:26: load_case.0.phase = 20 needs factor: it lags behind [load]");
    EXPECT_EQ(complaint(name + "factor = 1.0\nphase = 360.0\n"), "case.toml:26: load_case.0.phase = 360 must be < 360");
    EXPECT_EQ(complaint(name + "blocks = [ { cycles = 2, at_max = 1.0, at_min = 0.0 } ]\n"),
              "case.toml:23: load_case.0.blocks have 2 cycles, [load] has 3: there must be as many");
    std::string still = plate + held + name + "blocks = [ { cycles = 3, at_max = 1.0, at_min = 0.0 } ]\n";
    EXPECT_NO_THROW(read(still));
    still.replace(still.find("max = 50.0, ratio = -1.0"), 24, "max = 0.0, min = -50.0");
    EXPECT_THROW(read(still), CaseError) << "the first maximum never comes";
}

TEST_F(LoadCaseFile, RefusesPressuresThatCannotBe) {
    const std::string top = "[[boundary]]\non = \"top\"\n";
    EXPECT_EQ(complaint(top + "traction = [1.0, 0.0]\ncosine = [1.0, 0.0]\n"),
              "case.toml:22: boundary.2.cosine needs a pressure that it distributes");
    EXPECT_EQ(complaint(top + "pressure = 1.0\ncosine = [0.0, 0.0]\n"),
              "case.toml:22: boundary.2.cosine must not be zero: it is a direction");
    EXPECT_EQ(complaint(top + "pressure = 1.0\ncentre = [0.0, 0.0]\n"), "case.toml:22: boundary.2.centre needs cosine");
    const std::string wheel = "travelling = { p0 = 1.0, half_width = 1.0, from = 0.0, to = ";
    EXPECT_EQ(complaint(top + wheel + "0.0 }\n"), "case.toml:21: boundary.2.travelling.to must differ from from");
    EXPECT_EQ(complaint(top + "pressure = 1.0\n" + wheel + "1.0 }\n"),
              "case.toml:21: boundary.2.pressure does not go with travelling: give it a [[boundary]] of its own");
    EXPECT_EQ(complaint("[[boundary]]\non = \"point\"\nat = [0.0, 0.0]\n" + wheel + "1.0 }\n"),
              "case.toml:22: boundary.2.travelling needs an edge, not a point or pin");
}

}  // namespace
}  // namespace stria
