// Both components under an mpirun of the user's own, which is sent signals. Open MPI 4.1 answers SIGINT and SIGTERM
// itself: it passes them to the components, kills what is left after `odls_base_sigkill_timeout`, and ends with 1.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "app/results/run_files.hpp"
#include "tests/support/followed_run.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

void allow_mpirun() {
    for (const char* name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "OMPI_MCA_mpi_yield_when_idle",
                             "OMPI_MCA_rmaps_base_oversubscribe"})
        setenv(name, "1", 0);
}

class StartedByHand : public testing::Test {
protected:
    static void SetUpTestSuite() {
        allow_mpirun();
        of_all = std::make_unique<TemporaryFolder>();
        undisturbed = *of_all / "undisturbed";
        Words words{"run", shipped_sent, "-o", undisturbed, "--mode", "inprocess"};
        append_settings(words);
        ASSERT_EQ(run_program("stria", words, *of_all / "log"), 0);
    }
    static void TearDownTestSuite() { of_all.reset(); }

    void send(const Words& signals, int code) {
        Program run("mpirun", by_hand({}), folder / "log");
        ASSERT_TRUE(wait_for_rows(run, output, 14)) << run.said();
        for (const std::string& name : signals) {
            kill(run.pid(), name == "TERM" ? SIGTERM : name == "INT" ? SIGINT : SIGUSR1);
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        EXPECT_EQ(run.wait(std::chrono::seconds(30)), code) << run.said();
        EXPECT_EQ(run.said().find("*** Process received signal"), std::string::npos) << run.said();
        EXPECT_LT(rows_of(output + "/history.csv"), rows_of(undisturbed + "/history.csv"));
    }

    /// A component that mpirun has left alone needs a moment to notice; until then it holds the folder.
    void expect_to_go_on() {
        int code = 2;
        for (int k = 0; code == 2 && k < 50; ++k) {
            code = run_program("mpirun", by_hand({"--resume"}), folder / "log");
            if (code == 2) std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        EXPECT_EQ(code, 0) << text_of(folder / "log");
        expect_same_tables(output, undisturbed);
    }

    std::string status() { return read_json(output + "/summary.json").words["status"]; }

    const TemporaryFolder folder;
    const std::string output = folder / "out";
    inline static std::unique_ptr<TemporaryFolder> of_all;
    inline static std::string undisturbed;

private:
    // Long enough for a signal that mpirun passes on late: a second later, also on quiet cores.
    static void append_settings(Words& words) {
        for (const char* setting :
             {"mesh.size=12.5", "load.blocks=[{cycles=60, max=50.0, ratio=-1.0}]", "load.steps=20",
              "output.fields=none", "output.faces=cycles", "solver.tolerance=1e-12"})
            words.insert(words.end(), {"--set", setting});
        words.insert(words.end(), {"--set", mesh_at_tip(0.4)});
    }

    [[nodiscard]] Words by_hand(const Words& more) const {
        Words words;
        for (const char* program : {"stria-coarse", "stria-fine"}) {
            words.insert(words.end(), {"-n", "1", own_program(program), shipped_sent, "-o", output});
            append_settings(words);
            words.insert(words.end(), more.begin(), more.end());
            words.emplace_back(":");
        }
        words.pop_back();
        return words;
    }
};

/// A second fine rank is a program of its own, or lives with the structure.
TEST(RanksStartedByHand, LeaveWhatThoseOfOneProgramDo) {
    allow_mpirun();
    const TemporaryFolder folder;
    const auto component = [&](const char* count, const char* program, const std::string& output, Words more) {
        Words words{"-n", count, own_program(program), shipped_sent, "-o", output};
        for (const char* value : {"mesh.size=12.5", "load.blocks=[{cycles=2, max=50.0, ratio=-1.0}]", "load.steps=16",
                                  "output.fields=none"})
            more.insert(more.end(), {"--set", value});
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    const auto run = [&](const std::string& output, const Words& own, const char* others) {
        Words words = component("1", "stria-coarse", output, own);
        words.emplace_back(":");
        for (const std::string& word : component(others, "stria-fine", output, {})) words.push_back(word);
        EXPECT_EQ(run_program("mpirun", words, folder / "log"), 0) << text_of(folder / "log");
        return output;
    };
    const std::string apart = run(folder / "apart", {}, "2"), with = run(folder / "with", {"--own-rank"}, "1");
    expect_same_tables(apart, with);
    for (const std::string& output : {apart, with})
        EXPECT_EQ(read_json(output + "/summary.json").number("fine_ranks"), 2.0);
}

int lines_in(const std::string& text, const std::string& part) {
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// The structure with one case, the zone with another.
class CasesThatDiffer : public testing::Test {
protected:
    int run(const std::string& coarse, const std::string& fine) {
        allow_mpirun();
        Program both("mpirun",
                     {"-n", "1", own_program("stria-coarse"), coarse, "-o", folder / "out", "--force", ":", "-n", "1",
                      own_program("stria-fine"), fine},
                     folder / "log");
        return both.wait(std::chrono::seconds(30));
    }
    [[nodiscard]] std::string said() const { return text_of(folder / "log"); }

    const TemporaryFolder folder;
};

// Who needs no fine component would part and go on, and who needs one wait for ever.
TEST_F(CasesThatDiffer, AreRefusedWhereOneAloneNeedsAFineComponent) {
    const std::string elastic = folder / "elastic.toml";
    std::ofstream(elastic) << "units = 'N-mm-MPa'\n"
                              "mesh = { specimen = 'sent', width = 50.0, height = 100.0, size = 4.0 }\n"
                              "material = { young = 200e3, poisson = 0.3 }\n"
                              "crack = [ { points = [[0.0, 50.3], [10.0, 50.3]] } ]\n"
                              "boundary = [ { on = 'top', traction = [0.0, 1.0] }, "
                              "{ on = 'bottom', traction = [0.0, -1.0] } ]\n"
                              "load = { steps = 4, blocks = [ { cycles = 1, max = 40.0, ratio = 0.1 } ] }\n";
    for (const auto& [coarse, fine] : {std::pair{elastic, shipped_sent}, std::pair{shipped_sent, elastic}}) {
        EXPECT_EQ(run(coarse, fine), 2) << said();
        EXPECT_EQ(lines_in(said(), "stria-coarse: the coarse and the fine component were given different cases"), 1)
            << said();
        EXPECT_EQ(lines_in(said(), "were given different cases"), 1) << said();
        EXPECT_FALSE(std::filesystem::exists(folder / "out/history.csv"));
    }
}

TEST_F(CasesThatDiffer, AreComplainedAboutByWhomeverTheyWereGivenTo) {
    EXPECT_EQ(run(shipped_sent, "nowhere.toml"), 2) << said();
    EXPECT_EQ(lines_in(said(), "stria-fine: nowhere.toml: cannot be read, no such case file"), 1) << said();
}

// It writes no files. HDF5 brings thirty libraries, half of the time in which a program starts.
TEST(FineComponent, IsStartedWithoutHDF5) {
    const TemporaryFolder folder;
    const auto libraries_of = [&](const std::string& program) {
        const std::string list = folder / program;
        EXPECT_EQ(std::system(("LD_TRACE_LOADED_OBJECTS=1 " + own_program(program) + " > " + list).c_str()), 0);
        return text_of(list);
    };
    EXPECT_NE(libraries_of("stria-coarse").find("hdf5"), std::string::npos);
    EXPECT_EQ(libraries_of("stria-fine").find("hdf5"), std::string::npos);
}

TEST_F(StartedByHand, EndsAsInterruptedBySIGUSR1Long) {
    send({"USR1"}, 130);
    EXPECT_EQ(status(), "interrupted");
    expect_to_go_on();
}

TEST_F(StartedByHand, LeavesACheckpointOnSIGTERM) {
    send({"TERM"}, 1);
    EXPECT_EQ(status(), "interrupted");
    expect_to_go_on();
}

TEST_F(StartedByHand, LeavesACheckpointOnSIGINTLong) {
    send({"INT"}, 1);
    EXPECT_EQ(status(), "interrupted");
    expect_to_go_on();
}

// Then mpirun ends at once, and its components without it: what they have written before stays whole.
TEST_F(StartedByHand, LeavesWhatIsWrittenOnSIGTERMTwiceLong) {
    send({"TERM", "TERM"}, 1);
    expect_to_go_on();
}

TEST_F(StartedByHand, LeavesWhatIsWrittenOnSIGINTTwiceLong) {
    send({"INT", "INT"}, 1);
    expect_to_go_on();
}

/// Nobody needs a fine component: the programs meet and part, and the structure goes on without MPI.
TEST(ElasticStartedByHand, EndsAsInterruptedWhereMpirunIsKilled) {
    allow_mpirun();
    const TemporaryFolder folder;
    const std::string case_file = folder / "case.toml", output = folder / "out";
    std::ofstream(case_file) << "units = 'N-mm-MPa'\n"
                                "mesh = { specimen = 'sent', width = 50.0, height = 100.0, size = 4.0 }\n"
                                "material = { young = 200e3, poisson = 0.3 }\n"
                                "crack = [ { points = [[0.0, 50.3], [10.0, 50.3]] } ]\n"
                                "boundary = [ { on = 'top', traction = [0.0, 1.0] }, "
                                "{ on = 'bottom', traction = [0.0, -1.0] } ]\n"
                                "load = { steps = 20, blocks = [ { cycles = 3000, max = 40.0, ratio = 0.1 } ] }\n"
                                "output = { fields = 'none', checkpoint_every = 0 }\n";
    Words words;
    for (const char* program : {"stria-coarse", ":", "stria-fine"})
        if (*program == ':')
            words.emplace_back(program);
        else
            words.insert(words.end(), {"-n", "1", own_program(program), case_file, "-o", output});
    Program run("mpirun", words, folder / "log");
    ASSERT_TRUE(wait_for_rows(run, output, 30)) << run.said();
    kill(run.pid(), SIGKILL);
    EXPECT_EQ(run.wait(std::chrono::seconds(10)), 128 + SIGKILL);
    int code = 2;  // that of a folder in which another run is writing
    for (int k = 0; code == 2 && k < 50; ++k) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        code =
            run_program("stria", {"run", case_file, "-o", output, "--resume", "--max-seconds", "0.1"}, folder / "log");
    }
    EXPECT_EQ(code, 130) << text_of(folder / "log");
    EXPECT_NE(text_of(folder / "log").find("resumed from"), std::string::npos) << text_of(folder / "log");
}

}  // namespace
}  // namespace stria::test
