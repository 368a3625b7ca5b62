// Faces and fields of a run that growth ends before its load history does.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fstream>
#include <set>

#include "common/io/number_table.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

constexpr const char* plate_that_grows = R"(
units = "N-mm-MPa"
mesh = { specimen = "sent", width = 20.0, height = 40.0, size = 2.0 }
material = { young = 200e3, poisson = 0.3 }
crack = [ { points = [[0.0, 20.0], [8.0, 20.0]] } ]
boundary = [ { on = "top", traction = [0.0, 1.0] }, { on = "bottom", traction = [0.0, -1.0] } ]
load = { steps = 2, blocks = [ { cycles = 50, max = 10.0, ratio = 0.5 } ] }
growth = { increment = 1.0, direction = "straight" }
)";

class GrowthEnd : public testing::Test {
protected:
    void run(const std::string& setting, const std::string& another = "title=plate",
             const std::string& third = "title=plate") {
        std::ofstream(folder / "case.toml") << plate_that_grows;
        ASSERT_EQ(run_program("stria",
                              {"run", folder / "case.toml", "-o", folder / "out", "--mode", "inprocess", "--force",
                               "--set", setting, "--set", another, "--set", third},
                              folder / "log"),
                  0)
            << text_of(folder / "log");
        history = read_table(folder / "out/history.csv");
    }
    [[nodiscard]] std::set<double> increments_with_faces() const {
        const NumberTable faces = read_table(folder / "out/faces.csv");
        if (faces.rows == 0) return {};
        return {faces["increment"].begin(), faces["increment"].end()};
    }
    [[nodiscard]] bool summary_says(const std::string& sentence) const {
        return text_of(folder / "out/summary.json").find(sentence) != std::string::npos;
    }
    [[nodiscard]] long field_files() const {
        const std::filesystem::directory_iterator files(folder / "out/fields");
        return std::distance(begin(files), end(files));
    }

    TemporaryFolder folder;
    NumberTable history;
};

TEST_F(GrowthEnd, AtALengthAskedForLeavesTheExtremesOfItsLastCycle) {
    run("growth.until=11");
    const double last = history["increment"].back();
    EXPECT_EQ(history["a"].back(), 11.0);
    EXPECT_EQ(increments_with_faces(), (std::set<double>{last - 1, last}));  // the minimum and the maximum
    EXPECT_EQ(field_files(), 2);
    const std::string series = text_of(folder / "out/fields.hdf.series");
    const double cycle = history["cycle"].back();
    EXPECT_NE(series.find(fmt::format("\"time\": {}\n", cycle - 0.5)), std::string::npos) << series;
    EXPECT_NE(series.find(fmt::format("\"time\": {:.1f}\n", cycle)), std::string::npos) << series;
}

TEST_F(GrowthEnd, UnforeseenLeavesTheIncrementAtWhichItCame) {
    run("growth.toughness=350");
    EXPECT_LT(history["cycle"].back(), 50);
    EXPECT_EQ(increments_with_faces(), std::set<double>{history["increment"].back()});
    EXPECT_EQ(field_files(), 1);
}

// K falls by 9 % at a time, below the threshold.
TEST_F(GrowthEnd, ByArrestSaysThatNIsNotKnown) {
    run("growth={law=\"paris\", C=2e-13, m=3.0, increment=1.0, threshold=80.0, direction=\"straight\"}",
        "load={control=\"K\", K_gradient=-0.09, steps=2, blocks=[{cycles=50, max=200.0, ratio=0.5}]}");
    EXPECT_LT(history["a"].back(), 12.0);
    EXPECT_TRUE(summary_says("the crack was arrested within its last growth")) << text_of(folder / "log");
}

// dK is half of K_max.
TEST_F(GrowthEnd, ByArrestBeforeItHasBegunIsAWarning) {
    run("growth={law=\"paris\", C=2e-13, m=3.0, increment=1.0, threshold=150.0, direction=\"straight\"}",
        "load={control=\"K\", steps=2, blocks=[{cycles=50, max=200.0, ratio=0.5}]}");
    EXPECT_EQ(history["cycle"].back(), 1);
    EXPECT_TRUE(summary_says("nothing drives a tip any more")) << text_of(folder / "log");
}

// A node that is held lies ahead. That of the body alone is an end of its life.
TEST_F(GrowthEnd, ByTheMeshIsAWarning) {
    const std::string ends =
        "growth ends here, and not the life: crack.0.points: the tip at (15, 20) is 1 mm from a node";
    run("boundary=[{on=\"top\", traction=[0.0, 1.0]}, {on=\"bottom\", traction=[0.0, -1.0]}, "
        "{on=\"point\", at=[16.0, 20.0], displacement=[0.0, 0.0]}]");
    EXPECT_EQ(history["a"].back(), 14.0);
    EXPECT_TRUE(summary_says(ends)) << text_of(folder / "log");
    EXPECT_NE(text_of(folder / "log").find("warning: " + ends), std::string::npos) << text_of(folder / "log");
    run("output.history=\"cycles\"");
    EXPECT_EQ(history["a"].back(), 18.0);
    EXPECT_FALSE(summary_says("growth ends here"));
}

// It is no key of the case that is wrong, and no smaller elements help.
TEST_F(GrowthEnd, AtTheBoundarySaysThatTheCrackHasMetIt) {
    run("crack=[{points=[[5.0, 20.5], [13.0, 20.5]]}]");
    const std::string said = text_of(folder / "log");
    EXPECT_NE(said.find("growth ends here: crack 0 meets the boundary: the next advance takes a tip to (1, 20.5), 1 mm "
                        "from it and less than an element"),
              std::string::npos)
        << said;
}

// From a fifth to three fifths of the plate's width, in one growth and in more.
TEST_F(GrowthEnd, SaysByHowMuchNIsTooLarge) {
    const auto N_by = [&](double increment) {
        run(fmt::format("growth={{law=\"paris\", C=2e-13, m=3.0, increment={}, until=12.0, direction=\"straight\"}}",
                        increment),
            "crack=[{points=[[0.0, 20.0], [4.0, 20.0]]}]", "mesh.size=0.5");
        return read_table(folder / "out/cycles.csv")["N"].back();
    };
    const double known = N_by(0.25);
    EXPECT_FALSE(summary_says("N is too large"));
    for (const double increment : {8.0, 4.0, 2.0, 1.0}) {
        const double off = 100.0 * (N_by(increment) / known - 1.0);
        const std::string sentence = "N is too large by about ", summary = text_of(folder / "out/summary.json");
        ASSERT_TRUE(summary_says(sentence)) << increment;
        const double said = std::stod(summary.substr(summary.find(sentence) + sentence.size()));
        EXPECT_GT(said, 0.7 * off) << increment;
        EXPECT_LT(said, 1.2 * off) << increment;
    }
}

// 4096 stands for 4: the power of what drives the tip is larger than any number, and its share of that would be none.
TEST_F(GrowthEnd, ByALawThatHasNoRateSaysSo) {
    std::ofstream(folder / "case.toml") << plate_that_grows;
    const std::string laws[] = {"growth={law=\"paris\", C=1e-13, m=4096.0, increment=1.0}",
                                "growth={law=\"table\", ranges=[1.0, 1.01], rates=[1e-9, 1e3], increment=\"auto\"}"};
    for (const std::string& law : laws) {
        EXPECT_EQ(run_program("stria",
                              {"run", folder / "case.toml", "-o", folder / "out", "--mode", "inprocess", "--force",
                               "--set", law, "--set", "load.blocks=[{cycles=2, max=10.0, ratio=0.1}]"},
                              folder / "log"),
                  3);
        const std::string said = text_of(folder / "log");
        EXPECT_NE(said.find(" make da/dN of what drives it larger than any number"), std::string::npos) << said;
    }
}

TEST_F(GrowthEnd, ThatDoesNotComeLeavesTheExtremesOfTheLastCycleOfTheHistory) {
    run("load.blocks.0.cycles=2");
    EXPECT_EQ(history["cycle"].back(), 2);
    EXPECT_EQ(increments_with_faces().size(), 2U);
    EXPECT_EQ(field_files(), 2);
}

}  // namespace
}  // namespace stria::test
