// Faces without contact where metal flows: faces.csv has them up to the tip, and a run says where they overlap.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "common/io/number_table.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

constexpr const char* plate_without_contact = R"(
units = "N-mm-MPa"
mesh = { specimen = "sent", width = 20.0, height = 40.0, size = 2.0 }
material = { young = 200e3, poisson = 0.3, yield_stress = 300.0, kinematic = [ { C = 4000.0 } ] }
crack = [ { points = [[0.0, 20.0], [8.0, 20.0]] } ]
boundary = [ { on = "top", traction = [0.0, 1.0] }, { on = "bottom", traction = [0.0, -1.0] } ]
load = { blocks = [ { cycles = 1, max = 40.0, ratio = -0.3 } ] }
fine = { refine = 8 }
)";

class FreeFaces : public testing::TestWithParam<const char*> {
protected:
    FreeFaces() { std::ofstream(folder / "case.toml") << plate_without_contact; }
    void run(std::vector<std::string> settings) const {
        settings.insert(settings.begin(), {"run", folder / "case.toml", "-o", out, "--mode", GetParam(), "--force"});
        ASSERT_EQ(run_program("stria", settings, folder / "log"), 0) << text_of(folder / "log");
    }
    [[nodiscard]] bool says(const std::string& file, const std::string& text) const {
        return text_of(folder / file).find(text) != std::string::npos;
    }

    TemporaryFolder folder;
    std::string out = folder / "out";
};

TEST_P(FreeFaces, AreWrittenUpToTheTip) {
    run({});
    const NumberTable faces = read_table(out + "/faces.csv");
    std::vector<double> s;
    for (std::size_t row = 0; row < faces.rows; ++row)
        if (faces["increment"][row] == faces["increment"].front()) s.push_back(faces["s"][row]);
    ASSERT_TRUE(std::ranges::is_sorted(s));
    for (std::size_t k = 1; k < s.size(); ++k)
        EXPECT_LT(s[k] - s[k - 1], 1.0) << "half an element, behind " << s[k - 1];
    EXPECT_GT(s.back(), 7.9);
    EXPECT_LT(std::ranges::min(faces["opening"]), -1e-4) << "-12 MPa";
}

TEST_P(FreeFaces, AreSaidToOverlap) {
    run({});
    EXPECT_TRUE(says("log", "faces of crack 0 overlap, by ")) << text_of(folder / "log");
    EXPECT_FALSE(says("out/summary.json", "\"overlapping_faces\": 0"));
    EXPECT_TRUE(says("out/report.html", "increments in which faces without contact overlap"));
    run({"--set", "crack.0.contact={}"});
    EXPECT_FALSE(says("log", "overlap"));
    EXPECT_TRUE(says("out/summary.json", "\"overlapping_faces\": 0"));
}

TEST_P(FreeFaces, AreStillSaidToOverlapOnceTheRunWasResumed) {
    const auto warnings = [&] {
        const std::string all = text_of(folder / "out/summary.json");
        const std::size_t from = all.find("\"warnings\"");
        return all.substr(from, all.find(']', from) - from);
    };
    run({});
    ASSERT_NE(warnings().find("faces of crack 0 overlap, by "), std::string::npos);
    const std::string before = warnings();
    run({"--resume", "--set", "load.blocks.0.cycles=2"});
    EXPECT_TRUE(says("log", "resumed from"));
    EXPECT_EQ(warnings(), before);
}

TEST_P(FreeFaces, TellWhereTensionComesBackAheadOfThemInMetalThatNeverFlows) {
    std::ofstream(folder / "case.toml") << R"(
units = "N-mm-MPa"
mesh = { specimen = "sent", width = 20.0, height = 40.0, size = 2.0 }
material = { young = 200e3, poisson = 0.3 }
crack = [ { points = [[0.0, 20.0], [8.0, 20.0]] } ]
boundary = [ { on = "top", traction = [0.0, 1.0] }, { on = "bottom", traction = [0.0, -1.0] } ]
load = { steps = 10, blocks = [ { cycles = 1, max = 40.0, ratio = -0.3 } ] }
closure = { definition = "tension", distance = 0.5 }
)";
    run({});
    const NumberTable cycles = read_table(out + "/cycles.csv");
    EXPECT_NEAR(cycles["K_op_tension"][0], 0.0, 0.002 * cycles["K_max"][0])
        << "all stress is in proportion to the load";
    EXPECT_LT(cycles["K_min"][0], -0.2 * cycles["K_max"][0]);
    EXPECT_EQ(cycles["K_op"][0], cycles["K_op_tension"][0]);
}

INSTANTIATE_TEST_SUITE_P(Modes, FreeFaces, testing::Values("inprocess", "mpi", "monolithic"),
                         [](const auto& mode) { return mode.param; });

}  // namespace
}  // namespace stria::test
