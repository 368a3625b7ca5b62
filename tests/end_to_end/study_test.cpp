// `stria study` on a small elastic plate: the grid, its table and page, variants that fail, and bad input.
#include <gtest/gtest.h>

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <functional>

#include "common/io/number_table.hpp"
#include "tests/support/counted_words.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

constexpr const char* elastic_plate = R"(
units = "N-mm-MPa"
mesh = { specimen = "sent", width = 20.0, height = 40.0, size = 2.0 }
material = { young = 200e3, poisson = 0.3 }
crack = [ { points = [[0.0, 20.0], [8.0, 20.0]] } ]
boundary = [ { on = "top", traction = [0.0, 1.0] }, { on = "bottom", traction = [0.0, -1.0] } ]
load = { steps = 2, blocks = [ { cycles = 1, max = 10.0, ratio = 0.5 } ] }
output = { fields = "none" }
)";

/// Runs each task of an array as Slurm does: the script from elsewhere, as a copy, with the number in the environment.
constexpr const char* stands_for_sbatch = R"(set -eu
range=$(sed -n 's/^#SBATCH --array=//p' "$1")
cp "$1" "$1.spooled" && cd /
for task in $(seq "${range%-*}" "${range#*-}"); do
    SLURM_JOB_ID=7 SLURM_ARRAY_TASK_ID=$task bash "$1.spooled"
done
)";

/// Waits until it holds, half a minute at most.
bool comes_true(const std::function<bool()>& holds) {
    for (int tries = 0; tries < 6000 && !holds(); ++tries) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return holds();
}

class Study : public testing::Test {
protected:
    int run(std::vector<std::string> arguments) {
        std::ofstream(folder / "case.toml") << elastic_plate;
        arguments.insert(arguments.begin(), {"study", folder / "case.toml", "-o", folder / "out"});
        return run_program("stria", arguments, folder / "log");
    }
    [[nodiscard]] std::string said() const { return text_of(folder / "log"); }
    [[nodiscard]] NumberTable table() const { return read_table(folder / "out/study.csv"); }

    TemporaryFolder folder;
};

TEST_F(Study, RunsEveryCombinationAndComparesItWithItsReference) {
    ASSERT_EQ(run({"--over", "mesh.size=4,2", "--over", "material.poisson=0.2,0.3", "--reference", "mesh.size=1"}), 0)
        << said();
    const NumberTable rows = table();
    ASSERT_EQ(rows.rows, 4);
    EXPECT_EQ(rows["mesh.size"], (std::vector<double>{4, 4, 2, 2}));
    EXPECT_EQ(rows["material.poisson"], (std::vector<double>{0.2, 0.3, 0.2, 0.3}));
    EXPECT_LT(rows["coarse_unknowns"][0], rows["coarse_unknowns"][2]);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_GT(rows["error_K_I"][k], 0.0);
        EXPECT_LT(rows["error_K_I"][k + 2], rows["error_K_I"][k]);
        EXPECT_LT(rows["error_CMOD"][k + 2], rows["error_CMOD"][k]);
    }
    // Each is compared with the reference of its own Poisson's ratio, and J of plane strain has the factor 1 - nu^2.
    EXPECT_NEAR(rows["J"][2] / rows["J"][3], 0.96 / 0.91, 0.02);
    const NumberTable reference = read_table(folder / "out/reference-2/history.csv");
    const double J = *std::ranges::max_element(reference["J"]);
    EXPECT_NEAR(rows["error_J"][3], std::abs(rows["J"][3] / J - 1.0), 1e-12);
}

// Three sizes tell of a fourth within their uncertainty, and of elements half as large again nearer than the smallest.
TEST_F(Study, SaysHowFarResultsAreFromConverged) {
    const auto K_row = [&](const std::string& sizes) {
        EXPECT_EQ(run({"--over", "mesh.size=" + sizes, "--mode", "inprocess", "--no-report", "--force"}), 0) << said();
        std::ifstream file(folder / "out/convergence.csv");
        std::string line;
        while (std::getline(file, line) && !line.starts_with("K_I,")) {
        }
        std::vector<std::string> row;
        std::istringstream text(line);
        for (std::string cell; std::getline(text, cell, ',');) row.push_back(cell);
        return row;
    };
    const std::vector<std::string> row = K_row("2,4,1");
    ASSERT_EQ(row.size(), 10U) << said();
    EXPECT_EQ(row[4] + row[5], "3monotone");
    const double on_1 = std::stod(row[6]), order = std::stod(row[7]), limit = std::stod(row[8]),
                 band = std::stod(row[9]);
    const double on_half = std::stod(K_row("0.5,1").at(6));
    EXPECT_NEAR(order, 2.0, 0.4);
    EXPECT_LT(std::abs(on_half - on_1), band);
    EXPECT_LT(std::abs(limit - on_half), 0.5 * std::abs(on_1 - on_half));
    EXPECT_EQ(said().find("K_I: "), said().rfind("K_I: "));
    EXPECT_NE(said().find("in the limit by first order"), std::string::npos) << said();
    EXPECT_NE(text_of(folder / "out/study.html").find("Convergence with the size of elements"), std::string::npos);
    ASSERT_EQ(run({"--over", "load.scale=1,2", "--mode", "inprocess", "--no-report", "--force"}), 0) << said();
    EXPECT_FALSE(std::filesystem::exists(folder / "out/convergence.csv"));
}

TEST_F(Study, LeavesAPageThatNeedsNothingElse) {
    ASSERT_EQ(run({"--over", "mesh.size=4,2", "--mode", "mpi,inprocess", "--reference-value", "K_I=100"}), 0) << said();
    const std::string page = text_of(folder / "out/study.html");
    for (const char* part : {"<svg", "Error of K_I", "Total time", "Time by phase", "mode=inprocess", "</html>"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    for (const char* part : {"<script", "<link", "src=", "href=", "nan", "inf\""})
        EXPECT_EQ(page.find(part), std::string::npos) << part;
}

TEST_F(Study, SaysOfErrorsAtTheLevelOfRoundingThatTheyAre) {
    ASSERT_EQ(run({"--over", "load.steps=2,4", "--mode", "inprocess", "--reference", "load.steps=8"}), 0) << said();
    const std::string page = text_of(folder / "out/study.html");
    EXPECT_NE(page.find("Equal to rounding, with the largest error: J"), std::string::npos);
    EXPECT_EQ(page.find("Error of J"), std::string::npos);
    EXPECT_NE(page.find("<h2>At the end of the run</h2>"), std::string::npos);
    EXPECT_EQ(table()["N_end"], (std::vector<double>{1, 1}));
}

TEST_F(Study, AVariantThatFailsIsARowAndTheOthersGoOn) {
    EXPECT_EQ(
        run({"--over", "crack.0.points=[[30.0,20.0],[40.0,20.0]],[[0.0,20.0],[6.0,20.0]]", "--mode", "inprocess"}), 2);
    const NumberTable rows = table();
    const std::string text = text_of(folder / "out/study.csv");
    EXPECT_EQ(rows.rows, 0);  // values with commas are quoted, which is more than this reader of numbers knows
    EXPECT_NE(text.find(",wrong input,2,"), std::string::npos) << text;
    EXPECT_NE(text.find(",done,0,"), std::string::npos) << text;
    EXPECT_NE(said().find("wrong input"), std::string::npos);
}

TEST_F(Study, ResumeKeepsWhatIsDone) {
    ASSERT_EQ(run({"--over", "mesh.size=4", "--mode", "inprocess"}), 0) << said();
    EXPECT_EQ(run({"--over", "mesh.size=4", "--mode", "inprocess"}), 2);
    ASSERT_EQ(run({"--over", "mesh.size=4,2", "--mode", "inprocess", "--resume"}), 0) << said();
    EXPECT_EQ(table().rows, 2);
    EXPECT_NE(said().find("mesh.size=4  done before"), std::string::npos) << said();
    EXPECT_NE(said().find("mesh.size=2  done in"), std::string::npos) << said();
}

// The case names its mesh: what the file holds is not in it.
TEST_F(Study, ResumeTellsMeshesOfTheSameFileApart) {
    std::ofstream(folder / "part.toml") << R"(
units = "N-mm-MPa"
mesh = { file = "part.msh" }
material = { young = 200e3, poisson = 0.3 }
crack = [ { points = [[0.0, 50.0], [20.0, 50.0]] } ]
boundary = [ { on = "top", traction = [0.0, 1.0] }, { on = "bottom", traction = [0.0, -1.0] } ]
load = { steps = 2, blocks = [ { cycles = 1, max = 10.0, ratio = 0.5 } ] }
output = { fields = "none" }
)";
    const auto with = [&](const char* mesh, const char* how) {
        std::filesystem::copy_file(std::string(source_folder) + "/tests/data/meshes/" + mesh, folder / "part.msh",
                                   std::filesystem::copy_options::overwrite_existing);
        EXPECT_EQ(run_program("stria",
                              {"study", folder / "part.toml", "-o", folder / "out", "--mode", "inprocess", "--over",
                               "material.poisson=0.2,0.3", how},
                              folder / "log"),
                  0)
            << said();
        return table()["coarse_unknowns"];
    };
    const std::vector<double> before = with("sent-mixed.msh", "--force");
    EXPECT_EQ(with("sent-mixed.msh", "--resume"), before);
    EXPECT_EQ(count(said(), "done before"), 2) << said();
    EXPECT_NE(with("sent-quads.msh", "--resume"), before);
    EXPECT_EQ(count(said(), "done in"), 2) << said();
}

// In one process, and in as many as there are fine ranks.
TEST_F(Study, ResumeTellsNumbersOfFineRanksApart) {
    for (const std::string mode : {"inprocess", "mpi"}) {
        const auto with = [&](const char* ranks, const char* how) {
            EXPECT_EQ(run({"--set", "material.yield_stress=1e4", "--over", "mesh.size=4", "--mode", mode, "--fine",
                           ranks, how}),
                      0)
                << said();
            return said();
        };
        (void)with("1", "--force");
        EXPECT_NE(with("2", "--resume").find("done in"), std::string::npos) << said();
        EXPECT_NE(with("2", "--resume").find("done before"), std::string::npos) << said();
    }
}

/// A table without what two runs of one case differ in: times.
std::string without_times(const NumberTable& table) {
    std::string text;
    for (const auto& [name, values] : table.columns)
        if (!name.ends_with("_s") && !name.starts_with("ms_"))
            for (const double value : values) text += fmt::format("{} {}\n", name, value);
    return text;
}

TEST_F(Study, SeveralAtATimeGiveTheTableOfOneByOneInTheOrderOfTheVariants) {
    // The first takes much longer than the others, so it ends last.
    const std::vector<std::string> axes = {"--over", "mesh.size=0.25,4,2,3", "--mode", "inprocess"};
    ASSERT_EQ(run(axes), 0) << said();
    const std::string one_by_one = without_times(table());
    std::vector<std::string> several = axes;
    several.insert(several.end(), {"--jobs", "2", "--force"});
    ASSERT_EQ(run(several), 0) << said();
    EXPECT_EQ(without_times(table()), one_by_one);
    EXPECT_EQ(table()["mesh.size"], (std::vector<double>{0.25, 4, 2, 3}));
    EXPECT_GT(said().find("run 1 of 4"), said().find("run 2 of 4")) << said();
}

TEST_F(Study, OneThatFailsDoesNotStopThoseBesideIt) {
    const std::string outside = "[[30.0,20.0],[40.0,20.0]]", inside = "[[0.0,20.0],[6.0,20.0]]";
    EXPECT_EQ(run({"--over", "crack.0.points=" + outside + "," + inside, "--over", "mesh.size=2,4", "--mode",
                   "inprocess", "--jobs", "3"}),
              2);
    const std::string text = text_of(folder / "out/study.csv");
    EXPECT_EQ(count(text, ",wrong input,2,"), 2) << text;
    EXPECT_EQ(count(text, ",done,0,"), 2) << text;
}

TEST_F(Study, TableAndPageGrowWhileItRuns) {
    std::ofstream(folder / "case.toml") << elastic_plate;
    Program study(
        "stria",
        {"study", folder / "case.toml", "-o", folder / "out", "--mode", "inprocess", "--over", "load.steps=2,100000"},
        folder / "log");
    ASSERT_TRUE(comes_true([&] { return count(text_of(folder / "out/study.html"), "1 of 2 variants") == 1; }));
    EXPECT_EQ(count(text_of(folder / "out/study.csv"), ",done,0,"), 1);
    EXPECT_EQ(count(text_of(folder / "out/study.csv"), ",running,0,"), 1);
    EXPECT_NE(text_of(folder / "out/study.html").find("The study goes on"), std::string::npos);
    kill(study.pid(), SIGTERM);
    EXPECT_EQ(study.wait(std::chrono::seconds(60)), 130);
    EXPECT_EQ(text_of(folder / "out/study.html").find("The study goes on"), std::string::npos);
    EXPECT_EQ(count(text_of(folder / "out/study.csv"), ",interrupted,130,"), 1);
}

// The variant that runs goes on to its end: SIGINT is for the study alone, which a terminal would send to both.
TEST_F(Study, AnInterruptedOneIsNotDoneThoughAllThatHaveRunAre) {
    std::ofstream(folder / "case.toml") << elastic_plate;
    Program study("stria",
                  {"study", folder / "case.toml", "-o", folder / "out", "--mode", "inprocess", "--over",
                   "load.steps=1000,1002,1004"},
                  folder / "log");
    ASSERT_TRUE(comes_true([&] { return count(text_of(folder / "out/study.csv"), ",running,0,") == 1; }));
    kill(study.pid(), SIGINT);
    EXPECT_EQ(study.wait(std::chrono::seconds(60)), 130) << study.said();
    const std::string left = text_of(folder / "out/study.csv");
    EXPECT_GE(count(left, ",not run,0,"), 1) << left;
    EXPECT_EQ(count(left, ",not run,0,") + count(left, ",done,0,"), 3) << left;
}

TEST_F(Study, AnInterruptedOneGoesOnFromTheCheckpointsOfItsVariants) {
    std::ofstream(folder / "case.toml") << elastic_plate;
    const Words rest = {"-o",    folder / "out",   "--mode", "inprocess", "--over", "material.poisson=0.2,0.3,0.1",
                        "--set", "load.steps=200", "--jobs", "2"};
    Words words = {"study", folder / "case.toml"};
    words.insert(words.end(), rest.begin(), rest.end());
    Program study("stria", words, folder / "log");
    const std::string second = folder / "out/02-material.poisson=0.3/";
    ASSERT_TRUE(comes_true([&] { return count(text_of(second + "history.csv"), "\n") > 10; }));
    kill(study.pid(), SIGTERM);
    EXPECT_EQ(study.wait(std::chrono::seconds(60)), 130);
    ASSERT_TRUE(std::filesystem::exists(second + "checkpoint.h5")) << study.said();
    words.emplace_back("--resume");
    ASSERT_EQ(run_program("stria", words, folder / "log"), 0) << said();
    EXPECT_NE(text_of(second + "stria.log").find("resumed from"), std::string::npos) << text_of(second + "stria.log");
    EXPECT_EQ(table()["exit_code"], (std::vector<double>{0, 0, 0}));
    const std::string alone = folder / "alone";
    ASSERT_EQ(run_program("stria",
                          {"run", folder / "case.toml", "-o", alone, "--mode", "inprocess", "--set", "load.steps=200",
                           "--set", "material.poisson=0.3"},
                          folder / "log"),
              0);
    EXPECT_EQ(text_of(second + "history.csv"), text_of(alone + "/history.csv"));
}

TEST_F(Study, PrintsCommandsWhoseResultsItPicksUp) {
    const std::vector<std::string> axes = {"--over", "mesh.size=4,2", "--over", "crack.0.points=[[0, 20], [8, 20]]",
                                           "--mode", "inprocess"};
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = axes;
        all.insert(all.end(), more.begin(), more.end());
        return run(all);
    };
    ASSERT_EQ(with({"--print-commands"}), 0);
    ASSERT_EQ(count(said(), "\n"), 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    std::istringstream lines(said());
    std::string line;
    std::getline(lines, line);
    ASSERT_EQ(run_program("sh", {"-c", "cd / && " + line}, folder / "shell"), 0);
    ASSERT_EQ(with({"--jobs", "0"}), 0);
    EXPECT_EQ(count(text_of(folder / "out/study.csv"), ",done,0,"), 1);
    EXPECT_EQ(count(text_of(folder / "out/study.csv"), ",not run,0,"), 1);
    ASSERT_EQ(with({"--print-commands=slurm"}), 0);
    std::ofstream(folder / "array.sh") << said();
    EXPECT_NE(said().find("#SBATCH --array=1-2\n"), std::string::npos) << said();
    std::filesystem::remove_all(folder / "out");
    ASSERT_EQ(run_program("bash", {"-c", stands_for_sbatch, "sbatch", folder / "array.sh"}, folder / "shell"), 0);
    EXPECT_EQ(run_program("sh", {"-c", "SLURM_ARRAY_TASK_ID=3 bash " + (folder / "array.sh")}, folder / "shell"), 2);
    ASSERT_EQ(with({"--resume"}), 0) << said();
    EXPECT_EQ(count(said(), "done before"), 2) << said();
}

TEST_F(Study, BadInputIsOneLineBeforeAnythingIsRun) {
    const std::vector<std::vector<std::string>> wrong = {{},
                                                         {"--over", "mesh.size"},
                                                         {"--over", "mesh.size="},
                                                         {"--over", "mesh.siz=1,2"},
                                                         {"--over", "mesh.size=1,2", "--over", "mesh.size=3"},
                                                         {"--over", "mesh.size=1,2", "--set", "mesh.size=3"},
                                                         {"--over", "mesh.size=1,-2"},
                                                         {"--over", "mesh.size=1,2", "--mode", "mpi,psychic"},
                                                         {"--over", "mesh.size=1,2", "--jobs", "-1"},
                                                         {"--over", "mesh.size=1,2", "--print-commands=csh"},
                                                         {"--over", "mesh.size=1,2", "--reference", "nowhere"},
                                                         {"--over", "mesh.size=1,2", "--reference-value", "Q=3"}};
    for (const std::vector<std::string>& arguments : wrong) {
        EXPECT_EQ(run(arguments), 2) << said();
        EXPECT_EQ(std::ranges::count(said(), '\n'), 1) << said();
        EXPECT_FALSE(std::filesystem::exists(folder / "out/study.csv"));
    }
    run({"--over", "mesh.siz=1,2"});
    EXPECT_NE(said().find("did you mean mesh.size?"), std::string::npos) << said();
}

}  // namespace
}  // namespace stria::test
