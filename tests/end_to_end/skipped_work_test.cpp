// What a scene does not need is not made: read from the counters that its run leaves.
#include <gtest/gtest.h>

#include <fstream>
#include <vector>

#include "app/results/run_files.hpp"
#include "common/io/number_table.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

constexpr const char* plate = R"(
units = "N-mm-MPa"
mesh = { specimen = "sent", width = 20.0, height = 40.0, size = 2.0 }
material = { young = 200e3, poisson = 0.3 }
crack = [ { points = [[0.0, 20.0], [8.0, 20.0]] } ]
boundary = [ { on = "top", traction = [0.0, 1.0] }, { on = "bottom", traction = [0.0, -1.0] } ]
load = { steps = 6, blocks = [ { cycles = 1, max = 50.0, ratio = 0.0 } ] }
output = { fields = "none" }
)";

const std::vector<std::string> refined{"fine.refine=2", "fine.radius=4.0"};

class SkippedWork : public testing::TestWithParam<std::string> {
protected:
    /// Numbers of summary.json; none where the run has failed.
    std::map<std::string, double> run(const std::vector<std::string>& overrides, const std::string& text = plate) {
        std::ofstream(folder / "case.toml") << text;
        std::vector<std::string> words{"run",    folder / "case.toml", "-o",     folder / "out",
                                       "--mode", GetParam(),           "--force"};
        for (const std::string& value : overrides) words.insert(words.end(), {"--set", value});
        EXPECT_EQ(run_program("stria", words, folder / "log"), 0) << text_of(folder / "log");
        return read_json(folder / "out/summary.json").numbers;
    }
    [[nodiscard]] bool crosses() const { return GetParam() == "mpi"; }

    TemporaryFolder folder;
};

TEST_P(SkippedWork, ElasticWithoutContactAndRefinementStartsNoFineRank) {
    auto of = run({});
    for (const char* nothing :
         {"fine_ranks", "messages", "bytes", "fine_points", "fine_unknowns", "points_evaluated", "history_values",
          "interface_elements", "gaps_evaluated", "fronts_refactored", "interface_unknowns", "gamma_factored"})
        EXPECT_EQ(of.at(nothing), 0.0) << nothing;
    EXPECT_EQ(of.at("ranks"), 1.0);
    EXPECT_GT(of.at("structure_solves_near"), 0.0);
    EXPECT_LE(of.at("structure_solves_full"), 1.0);  // that of the checkpoint
}

// Of a body that answers in proportion the displacement at the load factor 1 tells all: K of the nominal body, rings
// and openings. It was found three times after each growth, and two of them were counted.
TEST_P(SkippedWork, AnElasticBodyIsSolvedOnceForEachLengthOfItsCrack) {
    auto of = run({"growth={law='prescribed',increment=0.7}", "load.blocks=[{cycles=6,max=50.0,ratio=0.0}]"});
    EXPECT_EQ(of.at("structure_solves_near"), 1.0) << "that of the first cycles, whose K wants the whole body";
}

TEST_P(SkippedWork, PlasticWithoutContactMakesNoInterfaceElement) {
    auto of = run({"material.yield_stress=300.0", "mesh.size=1.0", "fine.radius=4.0"});
    for (const char* nothing : {"interface_elements", "multipliers", "gaps_evaluated", "gaps_proven_open"})
        EXPECT_EQ(of.at(nothing), 0.0) << nothing;
    EXPECT_EQ(of.at("history_values"), 7.0 * of.at("fine_points"));  // plastic strain, p, work, dissipation
    EXPECT_GT(of.at("points_proven_elastic"), of.at("points_evaluated"));
    EXPECT_GT(of.at("elastic_tangents_reused"), of.at("tangents_computed"));
    EXPECT_EQ(of.at("fronts_kept") > 0.0, GetParam() != "monolithic");
    EXPECT_EQ(of.at("fine_ranks"), GetParam() == "monolithic" ? 0.0 : 1.0);
    EXPECT_EQ(of.at("tangents_not_sent") > 0.0, crosses());
    EXPECT_EQ(of.at("bytes_not_sent") > 0.0, crosses());
    EXPECT_GT(of.at("structure_checks_by_bound"), 0.0);
}

// Unloaded to nothing on the way: no force is left to measure a residual by.
TEST_P(SkippedWork, ElasticWithRefinementHasNoHistory) {
    auto of = run(refined);
    EXPECT_EQ(of.at("history_values"), 0.0);
    EXPECT_GT(of.at("fine_points"), 0.0);
    EXPECT_EQ(of.at("tangents_computed"), 0.0);
    EXPECT_EQ(of.at("step_cuts"), 0.0);
    EXPECT_EQ(of.at("interface_elements"), 0.0);
    EXPECT_LT(of.at("newton_iterations"), 2.0 * 9.0);
    const NumberTable history = read_table(folder / "out/history.csv");
    const std::vector<double>&load = history["load_factor"], &J = history["J"];
    for (std::size_t k = 0; k < load.size(); ++k)  // no memory of the way
        EXPECT_NEAR(J[k], J[2] * load[k] * load[k] / (load[2] * load[2]), 1e-9 * J[2]) << k;
}

TEST_P(SkippedWork, FacesThatAreWideOpenAreNotLookedAt) {
    auto of = run({"fine.radius=4.0"}, std::string(plate).replace(std::string(plate).find("[8.0, 20.0]]"), 12,
                                                                  "[8.0, 20.0]], contact = {}"));
    EXPECT_EQ(of.at("history_values"), 0.0);
    EXPECT_GT(of.at("interface_elements"), 0.0);
    EXPECT_GT(of.at("gaps_proven_open"), 0.0);
    EXPECT_GT(of.at("gaps_evaluated"), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Modes, SkippedWork, testing::Values("mpi", "inprocess", "monolithic"),
                         [](const auto& mode) { return mode.param; });

}  // namespace
}  // namespace stria::test
