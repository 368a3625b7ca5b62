// What a study reads of a run, how it compares runs, and the row it makes of one.
#include "app/study/variants/outcome.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>

#include "app/results/run_files.hpp"
#include "app/study/variants/table.hpp"
#include "common/index.hpp"
#include "common/io/number_table.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::study {
namespace {

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

/// Two increments up, one down, one up; two tips at each; faces as the last cycle left them.
void write_run(const test::TemporaryFolder& folder, const std::string& status) {
    write(folder / "summary.json", R"({"status": ")" + status +
                                       R"(", "fine_points": 100, "newton_iterations": 20, "messages": 40, "bytes": 800,
        "timing": {"exchange": 1.5, "coarse_solve": 0.5, "total": 3.0, "setup": null}, "tips": [{"J": 7}]})");
    write(folder / "history.csv", "increment,cycle,load_factor,tip,K_I,J,CMOD,CTOD,contact_length,plastic_zone\n"
                                  "1,0,1,0,10,1,,0.1,0,0.2\n1,0,1,1,90,9,,0.9,0,0.9\n"
                                  "2,0,2,0,20,4,,0.2,0,0.4\n2,0,2,1,90,9,,0.9,0,0.9\n"
                                  "3,1,-2,0,-5,0,,0,3.5,0.1\n3,1,-2,1,90,9,,0.9,8,0.9\n"
                                  "4,1,2,0,21,5,,0.3,0,0.5\n4,1,2,1,90,9,,0.9,0,0.9\n");
    write(folder / "faces.csv", "increment,crack,s,opening,status\n"
                                "3,0,1,0.0,1\n3,0,3,0.2,0\n3,0,2,0.0,1\n3,1,9,0.0,1\n"
                                "4,0,1,0.4,0\n4,0,3,0.0,0\n");
}

Outcome outcome_of_done_run() {
    const test::TemporaryFolder folder;
    write_run(folder, "done");
    return read_outcome(folder / "");
}

TEST(StudyOutcome, TakesTheFirstTipAtTheFirstLargestLoad) {
    const Outcome run = outcome_of_done_run();
    EXPECT_EQ(run.status, RunStatus::Done);
    EXPECT_EQ(run.value("J"), 4.0);
    EXPECT_EQ(run.value("K_I"), 20.0);
    EXPECT_EQ(run.value("plastic_zone"), 0.4);
    EXPECT_EQ(run.value("contact_length"), 3.5);
    EXPECT_TRUE(std::isnan(run.value("CMOD")));
}

TEST(StudyOutcome, TakesContactAndOpeningsFromTheFacesOfTheFirstCrack) {
    const Outcome run = outcome_of_done_run();
    EXPECT_EQ(run.value("contact_edge"), 2.0);
    EXPECT_EQ(run.at_minimum.s, (std::vector<double>{1, 2, 3}));
    EXPECT_DOUBLE_EQ(run.value("opening_at_min"), 0.05);
    EXPECT_DOUBLE_EQ(run.value("opening_at_max"), 0.2);
}

/// Openings at the largest and the smallest load of the last cycle; NaN where there are none. A pair is the cycle and
/// the load of an increment. Faces of each increment in `written` are as far apart as its number.
std::pair<double, double> openings_of(const std::vector<std::pair<int, double>>& increments,
                                      const std::vector<int>& written) {
    const test::TemporaryFolder folder;
    write(folder / "summary.json", R"({"status": "done"})");
    std::string history = "increment,cycle,load_factor,tip,K_I,J,CMOD,CTOD,contact_length,plastic_zone\n", faces;
    int number = 0;
    for (const auto& [cycle, load] : increments)
        history += fmt::format("{},{},{},0,1,1,1,1,1,1\n", ++number, cycle, load);
    for (const int increment : written) faces += fmt::format("{0},0,1,{0},0\n{0},0,2,{0},0\n", increment);
    write(folder / "history.csv", history);
    write(folder / "faces.csv", "increment,crack,s,opening,status\n" + faces);
    const Outcome run = read_outcome(folder / "");
    return {run.value("opening_at_max"), run.value("opening_at_min")};
}

using Openings = std::pair<double, double>;

TEST(StudyOutcome, TakesFacesAtTheExtremesOfTheLastCycleWhateverTheOthersHave) {
    // The ramp begins below the minimum.
    EXPECT_EQ(openings_of({{0, 1}, {0, 10}, {1, 5}, {1, 10}}, {3, 4}), Openings(4, 3));
    // An overload before, from which the last cycle comes down.
    EXPECT_EQ(openings_of({{0, 6}, {1, -3}, {1, 8}, {2, -4}, {2, 8}, {3, 7}, {3, -3}, {3, 6}}, {7, 8}), Openings(8, 7));
    EXPECT_EQ(openings_of({{0, 6}, {1, -3}, {1, 8}, {2, 7}, {2, -3}, {2, 6}}, {1, 2, 3, 4, 5, 6}), Openings(6, 5));
    // By K, the load falls as the crack grows; after the maximum of each cycle there is one more row.
    EXPECT_EQ(openings_of({{0, 10}, {0, 10}, {1, -5}, {1, 9}, {1, 9}, {2, -4}, {2, 8}, {2, 8}}, {6, 7, 8}),
              Openings(8, 6));
}

TEST(StudyOutcome, LeavesOutTheExtremeBeforeWhichGrowthHasEndedTheRun) {
    const Openings at_minimum = openings_of({{0, 10}, {1, -5}}, {2}), at_maximum = openings_of({{0, 5}, {0, 10}}, {2});
    EXPECT_EQ(at_minimum.second, 2.0);
    EXPECT_TRUE(std::isnan(at_minimum.first));
    EXPECT_EQ(at_maximum.first, 2.0);
    EXPECT_TRUE(std::isnan(at_maximum.second));
}

TEST(StudyOutcome, TakesTheEndOfTheRunFromTheLastCycleOfTheFirstTip) {
    const test::TemporaryFolder folder;
    write_run(folder, "done");
    write(folder / "cycles.csv",
          "cycle,tip,a,K_op,U,N\n1,0,10,90,0.8,1\n1,1,5,9,9,9\n2,0,11,100,0.7,2000\n2,1,5,9,9,9\n");
    const Outcome run = read_outcome(folder / "");
    EXPECT_EQ(run.value("a_end"), 11.0);
    EXPECT_EQ(run.value("N_end"), 2000.0);
    EXPECT_EQ(run.value("K_op_end"), 100.0);
    EXPECT_EQ(run.value("U_end"), 0.7);
    EXPECT_TRUE(std::isnan(run.value("life")));  // the load history has ended the run
    write(folder / "summary.json", R"({"status": "done", "life": 2000})");
    EXPECT_EQ(read_outcome(folder / "").value("life"), 2000.0);
}

TEST(StudyOutcome, DividesWorkByNewtonIterations) {
    const Outcome run = outcome_of_done_run();
    EXPECT_EQ(run.value("fine_points"), 100.0);
    EXPECT_EQ(run.value("total"), 3.0);
    EXPECT_EQ(run.value("messages_per_iteration"), 2.0);
    EXPECT_EQ(run.value("bytes_per_iteration"), 40.0);
    EXPECT_DOUBLE_EQ(run.value("ms_per_iteration"), 100.0);
    EXPECT_TRUE(std::isnan(run.value("setup")));
}

TEST(StudyOutcome, GivesNoResultsOfARunThatIsNotDone) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(read_outcome(folder / "nowhere").status, RunStatus::NotRun);
    write_run(folder, "failed");
    const Outcome run = read_outcome(folder / "");
    EXPECT_EQ(run.value("fine_points"), 100.0);
    EXPECT_TRUE(std::isnan(run.value("J")));
    EXPECT_TRUE(run.at_minimum.s.empty());
}

TEST(StudyOutcome, ReadsBrokenFilesAsEmptyOnes) {
    const test::TemporaryFolder folder;
    write(folder / "summary.json", "{\"status\": ");
    write(folder / "table.csv", "a,b\n1,2\n3");
    EXPECT_TRUE(read_json(folder / "summary.json").words.empty());
    EXPECT_EQ(read_table(folder / "table.csv").rows, 1);
    EXPECT_EQ(read_table(folder / "none.csv").rows, 0);
}

TEST(StudyOutcome, ErrorsAreRelative) {
    EXPECT_DOUBLE_EQ(relative_error(0.9, 1.0), 0.1);
    EXPECT_DOUBLE_EQ(relative_error(-3.0, -2.0), 0.5);
    EXPECT_EQ(relative_error(0.0, 0.0), 0.0);
    EXPECT_TRUE(std::isnan(relative_error(1.0, 0.0)));
    EXPECT_TRUE(std::isnan(relative_error(NAN, 1.0)));
}

TEST(StudyOutcome, ProfilesOnOtherStationsOfTheSameLineAreEqual) {
    const Profile coarse{{0.0, 4.0}, {1.0, 3.0}}, fine{{0.0, 1.0, 2.0, 4.0}, {1.0, 1.5, 2.0, 3.0}};
    EXPECT_NEAR(relative_error(coarse, fine), 0.0, 1e-15);
    const Profile tenth_more{{0.0, 4.0}, {1.1, 3.3}};
    EXPECT_NEAR(relative_error(tenth_more, coarse), 0.1, 1e-12);
    EXPECT_TRUE(std::isnan(relative_error(coarse, Profile{})));
    EXPECT_TRUE(std::isnan(relative_error(coarse, Profile{{0.0, 1.0}, {0.0, 0.0}})));
}

TEST(StudyTable, HasACellForEachColumn) {
    const std::vector<Axis> axes = {{"fine.beta", {"1"}}, {"mode", {"mpi"}}};
    Row row{.number = 1, .settings = {{"fine.beta", "1"}, {"mode", "mpi"}}};
    row.outcome.values["J"] = 4.0;
    row.errors["J"] = 0.25;
    for (const bool with_errors : {false, true}) {
        const std::vector<std::string> names = columns(axes, with_errors);
        const std::vector<Cell> line = cells(row, with_errors);
        ASSERT_EQ(line.size(), names.size());
        const auto cell = [&](const std::string& name) {
            return line.at(at(std::ranges::find(names, name) - names.begin()));
        };
        EXPECT_EQ(std::get<std::string>(cell("mode")), "mpi");
        EXPECT_EQ(std::get<double>(cell("J")), 4.0);
        if (with_errors) {
            EXPECT_EQ(std::get<double>(cell("error_J")), 0.25);
        }
    }
}

}  // namespace
}  // namespace stria::study
