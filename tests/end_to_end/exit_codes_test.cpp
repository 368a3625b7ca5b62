// How runs end that cannot go well: the exit code of the README and one line that says why.
#include <gtest/gtest.h>

#include <sys/resource.h>

#include "tests/support/program.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/small_disk.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

const Words quick{mesh_at_tip(0.3), "mesh.size=10.0", "load.blocks=[{cycles=1, max=50.0, ratio=-1.0}]", "load.steps=4"};

class ExitCode : public testing::Test {
protected:
    int run(const Words& more, const Words& settings = quick) {
        Words words{"run", shipped_sent, "-o", output};
        for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
        words.insert(words.end(), more.begin(), more.end());
        return run_program("stria", words, folder / "log");
    }
    [[nodiscard]] std::string said() const { return text_of(folder / "log"); }
    [[nodiscard]] bool says(const std::string& text) const { return said().find(text) != std::string::npos; }

    const TemporaryFolder folder;
    std::string output = folder / "out";
};

// In process: a limit on the size of files would hit the shared memory of mpirun's own daemon as well.
TEST_F(ExitCode, OfAFullDisk) {
    const SmallDisk disk(16384);
    EXPECT_EQ(run({"--mode", "inprocess"}), 5) << said();
    EXPECT_TRUE(says(": cannot be written: File too large")) << said();
    EXPECT_FALSE(std::filesystem::exists(output + "/summary.json"));
}

// Of the shell: that many blocks of 512 bytes, and a signal that would kill. Messages take another way then.
TEST_F(ExitCode, OfALimitOnTheSizeOfFiles) {
    for (const char* mode : {"inprocess", "mpi"}) {
        Words words{"-c",
                    "unset OMPI_MCA_btl; ulimit -f 80; exec \"$0\" \"$@\"",
                    own_program("stria"),
                    "run",
                    shipped_sent,
                    "--force",
                    "-o",
                    output,
                    "--mode",
                    mode};
        for (const std::string& setting : quick) words.insert(words.end(), {"--set", setting});
        EXPECT_EQ(run_program("sh", words, folder / "log"), 5) << mode << said();
        EXPECT_TRUE(says(": " + output)) << mode << said();
        EXPECT_TRUE(says(": cannot be written: File too large")) << mode << said();
    }
}

TEST_F(ExitCode, NamesAFolderThatCannotBeMade) {
    std::ofstream(folder / "file") << "no folder";
    output = folder / "file/out";
    EXPECT_EQ(run({"--mode", "inprocess"}), 5) << said();
    EXPECT_TRUE(says("file/out: the folder cannot be made: Not a directory")) << said();
}

// One that was copied away from its components, which follow one by one.
TEST_F(ExitCode, NamesAProgramThatIsNotThere) {
    const auto refused = [&](const std::string& path, const std::string& missing) {
        Words words{path, folder / "stria", "run", shipped_sent, "-o", output};
        for (const std::string& setting : quick) words.insert(words.end(), {"--set", setting});
        EXPECT_EQ(run_program("env", words, folder / "log"), 5) << said();
        EXPECT_TRUE(says(missing + ": there is no such program")) << said();
        EXPECT_TRUE(std::filesystem::is_empty(output));
    };
    const auto bring = [&](const std::string& name) { std::filesystem::copy_file(own_program(name), folder / name); };
    const std::string path = std::string("PATH=") + std::getenv("PATH");
    bring("stria");
    refused(path, folder / "stria-coarse");
    bring("stria-coarse");
    refused(path, folder / "stria-fine");
    bring("stria-fine");
    refused("PATH=/nowhere", "stria: mpirun");
}

// In a name space of its own, as containers have it.
TEST_F(ExitCode, IsZeroWithLittleSharedMemory) {
    const auto with = [&](const std::string& size) {
        Words words{"-rm",
                    "sh",
                    "-c",
                    "mount -t tmpfs -o size=" + size +
                        " tmpfs /dev/shm || exit 1; unset OMPI_MCA_btl; exec \"$0\" \"$@\"",
                    own_program("stria"),
                    "run",
                    shipped_sent,
                    "--force",
                    "-o",
                    output};
        for (const std::string& setting : quick) words.insert(words.end(), {"--set", setting});
        return run_program("unshare", words, folder / "log");
    };
    const int code = with("4m");
    if (code == 1 && !says("stria: ")) GTEST_SKIP() << "no name spaces here: " << said();
    EXPECT_EQ(code, 0) << said();
    EXPECT_EQ(with("4k"), 5) << said();
    EXPECT_TRUE(says("stria: /dev/shm: takes no more than 4096 bytes, too few")) << said();
}

TEST_F(ExitCode, OfASecondRunInTheFolder) {
    Words longer = quick;
    longer[3] = "load.steps=4000";
    Words words{"run", shipped_sent, "-o", output, "--mode", "inprocess"};
    for (const std::string& setting : longer) words.insert(words.end(), {"--set", setting});
    Program first("stria", words, folder / "first");
    for (int k = 0; k < 2000 && !std::filesystem::exists(output + "/history.csv"); ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    for (const char* mode : {"inprocess", "mpi"}) {
        EXPECT_EQ(run({"--force", "--mode", mode}), 2);
        EXPECT_TRUE(says("another run is writing into this folder")) << said();
    }
    kill(first.pid(), SIGTERM);
    EXPECT_EQ(first.wait(std::chrono::seconds(60)), 130);
}

TEST_F(ExitCode, OfTooLittleMemory) {
    rlimit before{};
    getrlimit(RLIMIT_AS, &before);
    for (const auto& [bytes, what] : {std::pair{rlim_t{1} << 29U, "fine.subcells: a zone of"},
                                      std::pair{rlim_t{150'000'000}, "linear algebra would take"}}) {
        const rlimit small{bytes, before.rlim_max};
        setrlimit(RLIMIT_AS, &small);
        EXPECT_EQ(run({"--mode", "inprocess", "--force", "--set", "fine.subcells=64"}), 2) << said();
        setrlimit(RLIMIT_AS, &before);
        EXPECT_TRUE(says(what)) << said();
    }
}

TEST_F(ExitCode, OfALimitLoad) {
    EXPECT_EQ(run({"--mode", "inprocess"},
                  {"mesh.grading=[]", "mesh.size=8.0", "load.steps=8", "load.blocks=[{cycles=1, max=150.0, ratio=0.0}]",
                   "crack.0.points=[[0.0, 100.0], [30.0, 100.0]]", "material.kinematic=[]",
                   "material.isotropic={law=\"voce\", Q=60.0, b=20.0}"}),
              3);
    EXPECT_TRUE(says("; the body bears no more, its loaded boundary has moved by 1")) << said();
    EXPECT_TRUE(says("load.control = \"displacement\" goes past its limit load; the last checkpoint is")) << said();
}

// It hardens for ever, so that small strains find an equilibrium under any load.
TEST_F(ExitCode, OfABodyThatGivesWay) {
    const std::vector<std::string> soft{"mesh.grading=[]",       "mesh.size=8.0",
                                        "load.steps=4",          "load.blocks=[{cycles=1, max=1000.0, ratio=0.0}]",
                                        "material.kinematic=[]", "material.isotropic={law=\"linear\", modulus=1000.0}"};
    EXPECT_EQ(run({"--mode", "inprocess"}, soft), 3);
    EXPECT_TRUE(says("the body gives way after 8 halvings; the last converged one reached load factor")) << said();
    std::vector<std::string> by_displacement = soft;
    by_displacement[3] = "load.blocks=[{cycles=1, max=25.0, ratio=0.0}]";
    by_displacement.emplace_back("load.control=displacement");
    EXPECT_EQ(run({"--mode", "inprocess", "--force"}, by_displacement), 0) << said();
}

// The notch ends where the crack's last element has no point of integration behind it.
TEST_F(ExitCode, IsZeroWithANotchUpToTheTip) {
    const double tip = 20.0;
    for (const double gap : {0.0, 1e-3, 1e-2})
        EXPECT_EQ(run({"--mode", "inprocess", "--force", "--set", "crack.0.notch=" + std::to_string(tip - gap)}), 0)
            << said();
}

// The row of elements that the crack would lie on moves.
TEST_F(ExitCode, IsZeroForACrackThatBendsBesideARow) {
    const Words words{
        "check", shipped_sent,      "--set", "mesh.size=5.0",
        "--set", "mesh.grading=[]", "--set", "crack.0.points=[[0.0, 100.0], [12.0, 100.0], [22.0, 107.0]]"};
    EXPECT_EQ(run_program("stria", words, folder / "log"), 0) << said();
}

// Before anybody asks where it enters an element.
TEST_F(ExitCode, IsTwoForACrackFromFarOutside) {
    EXPECT_EQ(run_program("stria",
                          {"check", std::string(source_folder) + "/cases/ct-pins/case.toml", "--set",
                           "crack.0.points=[[-12.5, 1e308], [25.0, 0.0]]"},
                          folder / "log"),
              2);
    EXPECT_TRUE(says("crack.0.points: (-12.5, 1e+308) is too far from the body")) << said();
}

// One line with the case, the key, the file and what is wrong in it.
TEST_F(ExitCode, IsTwoForAMeshFileThatIsNoBody) {
    std::ofstream(folder / "part.inp") << "*NODE\n1,0,0\n2,1,0\n3,1,1\n*ELEMENT,TYPE=CPS3\n1,1,2,4\n";
    const std::string file = folder / "case.toml";
    std::ofstream(file) << "units = \"N-mm-MPa\"\n[mesh]\nfile = \"part.inp\"\n[material]\nyoung = 1e5\npoisson = 0.3\n"
                           "[[boundary]]\non = \"top\"\npressure = 1.0\n[load]\nblocks = [{ max = 1, ratio = 0 }]\n";
    EXPECT_EQ(run_program("stria", {"check", file}, folder / "log"), 2) << said();
    EXPECT_EQ(said(),
              "stria: " + file + ": mesh.file: part.inp: element 1 has the node 4, which the file does not give\n");
}

class Refused : public ExitCode, public testing::WithParamInterface<std::pair<const char*, const char*>> {};

TEST_P(Refused, WithOneSentence) {
    const auto [setting, sentence] = GetParam();
    for (const char* command : {"run", "check"}) {
        Words words{command, shipped_sent, "--set", mesh_at_tip(0.3), "--set", "mesh.size=10.0", "--set", setting};
        if (std::string_view(command) == "run") words.insert(words.end(), {"-o", output, "--mode", "inprocess"});
        EXPECT_EQ(run_program("stria", words, folder / "log"), 2) << said();
        EXPECT_TRUE(says(sentence)) << said();
    }
}

INSTANTIATE_TEST_SUITE_P(
    Input, Refused,
    testing::Values(std::pair{"crack.0.points=[[0.0, 100.0], [50.0, 100.0]]", "crack.0.points: the crack cuts through"},
                    std::pair{"crack.0.points=[[0.0, 100.0], [0.1, 100.0]]", "less than an element at its tip"},
                    std::pair{"crack.0.points=[[0.0, 100.0], [1e-308, 100.0]]", "less than an element at its tip"},
                    std::pair{"crack.0.points=[[0.0, 100.0], [49.0, 100.0]]",
                              "mm from the boundary, less than an element"},
                    std::pair{"boundary.0={on=\"point\", at=[20.0, 100.0], force=[0.0, 1.0]}",
                              "mm from a node that is loaded or held, less than an element"},
                    std::pair{"mesh.grading.0.size=1e-9", "is too small beside the body"},
                    std::pair{"fine.refine=4096", "fine.refine = 4096: elements of"},
                    std::pair{"load.scale=5e-324", "beyond all use"}));

}  // namespace
}  // namespace stria::test
