// Runs whose components are killed, or which are asked to stop, and are resumed: the tables are those of the run that
// nobody disturbed.
#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "app/results/run_files.hpp"
#include "tests/support/followed_run.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

/// The crack grows at the maximum of three cycles; its faces close in each.
const Words settings{mesh_at_tip(0.3),     "mesh.size=10.0",        "load.blocks=[{cycles=3, max=50.0, ratio=-1.0}]",
                     "load.steps=20",      "growth.increment=0.25", "solver.tolerance=1e-12",
                     "output.fields=none", "output.faces=cycles",   "output.checkpoint_every=1"};
constexpr int whole_rows = 10 + 3 * 21;

Words command(const std::string& output, const Words& more = {}, const Words& of_case = settings) {
    Words words{"run", shipped_sent, "-o", output};
    for (const std::string& setting : of_case) words.insert(words.end(), {"--set", setting});
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

class Resumed : public testing::Test {
protected:
    static void SetUpTestSuite() {
        of_all = std::make_unique<TemporaryFolder>();
        undisturbed = *of_all / "undisturbed";
        ASSERT_EQ(run_program("stria", command(undisturbed, {"--mode", "inprocess"}), *of_all / "log"), 0);
        ASSERT_EQ(rows_of(undisturbed + "/history.csv"), whole_rows);
    }
    static void TearDownTestSuite() { of_all.reset(); }

    /// Starts or resumes, and kills a program (or all) once there are so many rows; the exit code of `stria`.
    int run_and_kill(const std::string& program, int rows, const Words& more = {}) {
        Program run("stria", command(output, more), folder / "log");
        EXPECT_TRUE(wait_for_rows(run, output, rows)) << run.said();
        for (const pid_t process : descendants(run.pid(), program)) kill(process, SIGKILL);
        return run.wait(std::chrono::seconds(60));
    }
    int run_and_ask(int signal, int rows, const Words& more = {}) {
        Program run("stria", command(output, more), folder / "log");
        EXPECT_TRUE(wait_for_rows(run, output, rows)) << run.said();
        kill(run.pid(), signal);
        return run.wait(std::chrono::seconds(60));
    }
    int run_to_the_end(const Words& more) { return run_program("stria", command(output, more), folder / "log"); }

    const TemporaryFolder folder;
    const std::string output = folder / "out";
    inline static std::unique_ptr<TemporaryFolder> of_all;
    inline static std::string undisturbed;
};

// Before the first checkpoint, between two, and where the crack has grown.
TEST_F(Resumed, AfterComponentsWereKilled) {
    EXPECT_EQ(run_and_kill("stria-coarse", 5, {"--set", "output.checkpoint_every=0"}), 4);
    EXPECT_FALSE(std::filesystem::exists(output + "/checkpoint.h5"));
    EXPECT_EQ(run_and_kill("stria-fine", 40, {"--resume"}), 4);
    EXPECT_NE(text_of(folder / "log").find("no checkpoint yet"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(output + "/checkpoint.h5"));
    EXPECT_EQ(run_and_kill("stria-coarse", 58, {"--resume"}), 4);
    EXPECT_NE(text_of(folder / "log").find("resumed from"), std::string::npos);
    EXPECT_EQ(run_to_the_end({"--resume"}), 0) << text_of(folder / "log");
    expect_same_tables(output, undisturbed);
}

// Its components notice that after a second or two and write until then: `stria` ends after them.
TEST_F(Resumed, AtOnceAfterMpirunWasKilled) {
    EXPECT_EQ(run_and_kill("orterun", 40), 4);
    EXPECT_EQ(run_to_the_end({"--resume"}), 0) << text_of(folder / "log");
    expect_same_tables(output, undisturbed);
}

TEST_F(Resumed, AfterItWasAskedToStop) {
    EXPECT_EQ(run_and_ask(SIGTERM, 14), 130);
    EXPECT_EQ(read_json(output + "/summary.json").words["status"], "interrupted");
    const int rows = rows_of(output + "/history.csv");
    EXPECT_LT(rows, whole_rows);
    EXPECT_EQ(run_and_ask(SIGINT, rows + 8, {"--resume", "--mode", "inprocess"}), 130);
    EXPECT_NE(text_of(folder / "log").find("interrupted: the last checkpoint is"), std::string::npos);
    EXPECT_EQ(run_to_the_end({"--resume"}), 0) << text_of(folder / "log");
    EXPECT_EQ(read_json(output + "/summary.json").words["status"], "done");
    expect_same_tables(output, undisturbed);
    EXPECT_EQ(run_to_the_end({"--resume"}), 0);
    EXPECT_NE(text_of(folder / "log").find("nothing is left to do"), std::string::npos);
    EXPECT_EQ(read_json(output + "/summary.json").words["status"], "done");
    expect_same_tables(output, undisturbed);
}

// Newton's method is at work and leads nowhere: without a force before it nothing passes for rounding.
TEST_F(Resumed, AfterItWasAskedToStopWithinAnIncrement) {
    for (const std::string mode : {"inprocess", "mpi"}) {
        Program run("stria",
                    command(output, {"--force", "--mode", mode, "--set", "solver.tolerance=1e-18", "--set",
                                     "solver.max_iterations=10000", "--set", "solver.max_cuts=40"}),
                    folder / mode);
        for (int k = 0; k < 4000 && run.said().find(" of them in the zone") == std::string::npos; ++k)
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        kill(run.pid(), SIGTERM);
        EXPECT_EQ(run.wait(std::chrono::seconds(10)), 130) << run.said();
        EXPECT_NE(run.said().find("interrupted: no checkpoint has been written yet; --resume begins anew"),
                  std::string::npos)
            << run.said();
        EXPECT_EQ(read_json(output + "/summary.json").words["status"], "interrupted");
    }
    EXPECT_EQ(run_to_the_end({"--resume", "--mode", "inprocess"}), 0) << text_of(folder / "log");
    expect_same_tables(output, undisturbed);
}

// As a batch system wants it: each job takes the time that it is given and leaves the rest to the next one.
TEST_F(Resumed, AfterItsTimeWasUp) {
    const Words endless{"--force", "--set", "solver.tolerance=1e-18", "--set", "solver.max_iterations=10000"};
    for (const std::string mode : {"inprocess", "mpi"}) {
        Words words = command(output, endless);
        words.insert(words.end(), {"--mode", mode, "--max-seconds", "0.7"});
        Program run("stria", words, folder / mode);
        EXPECT_EQ(run.wait(std::chrono::seconds(20)), 130) << run.said();
        EXPECT_NE(run.said().find("its time is up: no checkpoint has been written yet"), std::string::npos)
            << run.said();
        EXPECT_EQ(read_json(output + "/summary.json").words["status"], "interrupted");
    }
    double seconds = 0.2;
    int code = 130;
    for (; code == 130 && seconds < 60.0; seconds *= 1.5)
        code = run_to_the_end({"--resume", "--mode", "inprocess", "--max-seconds", std::to_string(seconds)});
    EXPECT_EQ(code, 0) << text_of(folder / "log");
    expect_same_tables(output, undisturbed);
    EXPECT_EQ(run_to_the_end({"--resume", "--max-seconds", "0"}), 2);
    EXPECT_EQ(run_to_the_end({"--resume", "--max-seconds", "nan"}), 2);
    EXPECT_NE(text_of(folder / "log").find("--max-seconds nan: must be a number > 0"), std::string::npos);
}

TEST_F(Resumed, InAnotherMode) {
    EXPECT_EQ(run_and_ask(SIGTERM, 55, {"--mode", "inprocess"}), 130);
    EXPECT_EQ(run_to_the_end({"--resume", "--mode", "monolithic"}), 0) << text_of(folder / "log");
    expect_tables_alike(output, undisturbed);
}

TEST_F(Resumed, WithMoreCycles) {
    Words fewer = settings;
    fewer[2] = "load.blocks=[{cycles=2, max=50.0, ratio=-1.0}]";
    ASSERT_EQ(run_program("stria", command(output, {"--mode", "inprocess"}, fewer), folder / "log"), 0);
    EXPECT_EQ(run_to_the_end({"--resume", "--mode", "inprocess"}), 0) << text_of(folder / "log");
    expect_same_tables(output, undisturbed);
}

// Extremes of what was the last cycle are none of the longer run.
TEST(ResumedLonger, HasTheFilesOfTheUndisturbedRun) {
    const TemporaryFolder folder;
    const auto run = [&](const std::string& output, const char* cycles, const Words& more) {
        const std::string blocks = std::string("load.blocks=[{cycles=") + cycles + ", max=50.0, ratio=-1.0}]";
        return run_program("stria",
                           command(folder / output, more, {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=4", blocks}),
                           folder / "log");
    };
    const auto files = [&](const std::string& output) {
        std::set<std::string> names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / output))
            names.insert(std::filesystem::relative(entry.path(), folder / output).string());
        names.erase("checkpoint.previous.h5");
        return names;
    };
    ASSERT_EQ(run("whole", "3", {"--mode", "inprocess"}), 0);
    ASSERT_EQ(run("longer", "2", {"--mode", "inprocess"}), 0);
    ASSERT_NE(files("longer"), files("whole"));
    ASSERT_EQ(run("longer", "3", {"--mode", "inprocess", "--resume"}), 0) << text_of(folder / "log");
    EXPECT_EQ(files("longer"), files("whole"));
    expect_same_tables(folder / "longer", folder / "whole");
    EXPECT_EQ(text_of(folder / "longer/fields.hdf.series"), text_of(folder / "whole/fields.hdf.series"));
}

TEST_F(Resumed, FromTheCheckpointBeforeADamagedOne) {
    EXPECT_EQ(run_and_ask(SIGTERM, 55, {"--mode", "inprocess"}), 130);
    const std::string newest = output + "/checkpoint.h5", previous = output + "/checkpoint.previous.h5";
    ASSERT_TRUE(std::filesystem::exists(previous));
    {
        std::fstream file(newest, std::ios::binary | std::ios::in | std::ios::out);
        file.seekp(static_cast<std::streamoff>(std::filesystem::file_size(newest) / 2));
        const char bit = static_cast<char>(file.peek() ^ 1);
        file.put(bit);
    }
    EXPECT_EQ(run_to_the_end({"--resume", "--mode", "inprocess"}), 0) << text_of(folder / "log");
    EXPECT_NE(text_of(folder / "log").find("is damaged, its checksum is another one; the one before it serves"),
              std::string::npos)
        << text_of(folder / "log");
    expect_same_tables(output, undisturbed);
}

TEST_F(Resumed, KeepsItsFormatOfFields) {
    EXPECT_EQ(run_and_ask(SIGTERM, 33, {"--mode", "inprocess"}), 130);
    EXPECT_EQ(run_to_the_end({"--resume", "--mode", "inprocess", "--set", "output.format=vtu"}), 2);
    EXPECT_NE(text_of(folder / "log").find("[output] but for its format"), std::string::npos)
        << text_of(folder / "log");
}

TEST_F(Resumed, NamesTheRemedyWhereATableIsShorter) {
    EXPECT_EQ(run_and_ask(SIGTERM, 33, {"--mode", "inprocess"}), 130);
    std::filesystem::resize_file(output + "/history.csv", 1000);
    EXPECT_EQ(run_to_the_end({"--resume", "--mode", "inprocess"}), 2);
    EXPECT_NE(text_of(folder / "log").find("start anew with --force"), std::string::npos) << text_of(folder / "log");
}

TEST_F(Resumed, AfterTheNumbersFailed) {
    EXPECT_EQ(run_and_ask(SIGTERM, 33, {"--mode", "inprocess"}), 130);
    const Words too_few{"--set", "solver.max_iterations=1", "--set", "solver.max_cuts=0", "--mode", "inprocess"};
    Words failing{"--resume"};
    failing.insert(failing.end(), too_few.begin(), too_few.end());
    EXPECT_EQ(run_to_the_end(failing), 3);
    EXPECT_NE(text_of(folder / "log").find("; the last checkpoint is " + output + "/checkpoint.h5, after increment"),
              std::string::npos)
        << text_of(folder / "log");
    EXPECT_EQ(run_to_the_end({"--resume", "--mode", "inprocess"}), 0);
    expect_same_tables(output, undisturbed);
    failing.front() = "--force";
    failing.insert(failing.end(), {"--set", "load.steps=2"});  // the first increment flows
    EXPECT_EQ(run_to_the_end(failing), 3);
    EXPECT_NE(text_of(folder / "log").find("no checkpoint has been written yet"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(output + "/checkpoint.h5"));
}

// A run that finds no equilibrium leaves the last one, before and while the forces on its new faces are released.
TEST(ResumedGrowth, GoesOnWhereItsNewFacesCouldNotBeReleased) {
    const TemporaryFolder folder;
    const auto run = [&](const std::string& output, const char* cuts, const Words& more) {
        Words words = command(folder / output, more,
                              {mesh_at_tip(0.6), "mesh.size=12.5", "load.blocks=[{cycles=2, max=50.0, ratio=-1.0}]",
                               "load.steps=20", "growth.increment=0.8", "solver.tolerance=1e-12",
                               "solver.max_iterations=5", "output.fields=none", "output.checkpoint_every=0"});
        words.insert(words.end(), {"--mode", "inprocess", "--set", std::string("solver.max_cuts=") + cuts});
        return run_program("stria", words, folder / "log");
    };
    ASSERT_EQ(run("whole", "3", {}), 0);
    ASSERT_EQ(run("failed", "0", {}), 3);
    EXPECT_NE(text_of(folder / "log")
                  .find("cycle 1: the cracks have grown to a = 20.8 mm; at load factor 50 no "
                        "equilibrium is found with less than 100 % of the forces"),
              std::string::npos)
        << text_of(folder / "log");
    EXPECT_NE(text_of(folder / "log").find("/checkpoint.h5, after increment 30"), std::string::npos);
    ASSERT_EQ(run("failed", "1", {"--resume"}), 3);
    EXPECT_NE(text_of(folder / "log").find("with less than 50 % of the forces"), std::string::npos);
    ASSERT_EQ(run("failed", "3", {"--resume"}), 0) << text_of(folder / "log");
    expect_same_tables(folder / "failed", folder / "whole");
}

TEST_F(Resumed, IsRefusedWithAnotherCase) {
    EXPECT_EQ(run_and_ask(SIGTERM, 12, {"--mode", "inprocess"}), 130);
    EXPECT_EQ(run_to_the_end({"--resume", "--set", "material.young=210e3"}), 2);
    EXPECT_NE(text_of(folder / "log").find("[material] \"young = 210000"), std::string::npos)
        << text_of(folder / "log");
    EXPECT_EQ(run_to_the_end({"--resume", "--set", "load.blocks=[{cycles=3, max=51.0, ratio=-1.0}]"}), 2);
    EXPECT_EQ(run_to_the_end({}), 2);
    EXPECT_NE(text_of(folder / "log").find("--resume goes on"), std::string::npos);
    std::filesystem::remove(output + "/checkpoint.previous.h5");
    std::filesystem::resize_file(output + "/checkpoint.h5", std::filesystem::file_size(output + "/checkpoint.h5") / 2);
    EXPECT_EQ(run_to_the_end({"--resume", "--mode", "inprocess"}), 2);
    EXPECT_NE(text_of(folder / "log").find("cannot go on from this checkpoint"), std::string::npos);
}

// With faces that close and three fine ranks, one of them with the structure.
TEST(ResumedSharedZone, AfterAFineRankWasKilled) {
    const TemporaryFolder folder;
    const Words scene{mesh_at_tip(0.4),
                      "mesh.size=12.5",
                      "load.steps=16",
                      "load.blocks=[{cycles=3, max=50.0, ratio=-1.0}]",
                      "solver.tolerance=1e-12",
                      "output.fields=none",
                      "output.checkpoint_every=1"};
    const std::string whole = folder / "whole", output = folder / "out";
    ASSERT_EQ(run_program("stria", command(whole, {"--mode", "inprocess", "--fine", "3"}, scene), folder / "log"), 0);
    {
        Program run("stria", command(output, {"--fine", "3"}, scene), folder / "log");
        ASSERT_TRUE(wait_for_rows(run, output, 30)) << run.said();
        const std::vector<pid_t> fine = descendants(run.pid(), "stria-fine");
        ASSERT_EQ(fine.size(), 2U);
        kill(fine.back(), SIGKILL);
        EXPECT_EQ(run.wait(std::chrono::seconds(60)), 4);
    }
    std::filesystem::copy(output, folder / "one", std::filesystem::copy_options::recursive);
    ASSERT_EQ(run_program("stria", command(output, {"--resume", "--fine", "3"}, scene), folder / "log"), 0);
    expect_same_tables(output, whole);
    ASSERT_EQ(run_program("stria", command(folder / "one", {"--resume", "--mode", "inprocess"}, scene), folder / "log"),
              0);
    expect_tables_alike(folder / "one", whole);
}

}  // namespace
}  // namespace stria::test
