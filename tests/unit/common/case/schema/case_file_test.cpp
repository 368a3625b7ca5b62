// A case file as a whole: defaults, complaints with their lines, values of the command line.
#include "common/case/schema/case_file.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include "common/case/case_questions.hpp"
#include "common/error.hpp"
#include "common/memory.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/folders.hpp"

namespace stria::test {
namespace {

TEST_F(CaseFile, ReadsValuesAndDefaults) {
    const Case scene = read(complete);
    EXPECT_EQ(scene.name, "plate");
    EXPECT_EQ(scene.mesh.height, 200.0);
    ASSERT_EQ(scene.mesh.grading.size(), 1U);
    EXPECT_EQ(scene.mesh.grading[0].at, std::vector<Vec2>{Vec2(20.0, 100.0)});
    EXPECT_EQ(scene.mesh.grading[0].growth, 0.25);
    EXPECT_EQ(scene.material.yield_stress, 300.0);
    EXPECT_EQ(scene.material.kinematic.at(0).gamma, 0.0);
    EXPECT_EQ(scene.cracks.at(0).points.at(1), Vec2(20.0, 100.0));
    EXPECT_TRUE(scene.cracks[0].contact);
    EXPECT_FALSE(scene.boundaries.at(1).displacement[0]);
    EXPECT_EQ(scene.boundaries[1].displacement[1], 0.0);
    EXPECT_EQ(scene.load.blocks.at(0).min, -50.0);
    EXPECT_TRUE(scene.load.steps.is_auto());
    EXPECT_EQ(scene.load.first_steps(), 12);
    EXPECT_TRUE(needs_fine(scene));
}

TEST_F(CaseFile, ResolvedTextGivesAnEqualCase) {
    const Case scene =
        read(complete, {"title=\"a \\\"quoted\\\" \\\\ title\"", "material.poisson=0.1234567890123456789",
                        "fine.enrichment=single", "solver.tolerance=1e-12"});
    const std::string resolved = resolved_toml(scene);
    const std::string path = (folder_ / "case.resolved.toml").string();
    std::ofstream(path) << resolved;
    const Case again = read_case(path);
    EXPECT_TRUE(again == scene) << resolved;
    EXPECT_EQ(resolved_toml(again), resolved);
    EXPECT_EQ(digest(again), digest(scene));
    EXPECT_NE(digest(read(complete)), digest(scene));
}

TEST_F(CaseFile, PointsAtTheLineOfAValueOutOfRange) {
    EXPECT_EQ(complaint_about("yield_stress = 300.0", "yield_stress = -350.0"),
              "case.toml:12: material.yield_stress = -350 MPa must be > 0");
    EXPECT_EQ(complaint_about("yield_stress = 300.0", "yield_stress = 1e-308"),
              "case.toml:12: material.yield_stress = 1e-308 MPa must be at least 1e-9 of young");
    EXPECT_EQ(complaint_about("poisson = 0.3", "poisson = 0.5"), "case.toml:11: material.poisson = 0.5 must be < 0.5");
    EXPECT_EQ(complaint_about("young = 200e3", "young = 1e-308"),
              "case.toml:10: material.young = 1e-308 MPa must be >= 1e-06");
    EXPECT_EQ(complaint_about("young = 200e3", "young = nan"), "case.toml:10: material.young = nan MPa must be finite");
    EXPECT_EQ(complaint_about("[load]", "[load]\nsteps = 5"), "case.toml:25: load.steps = 5 must be even");
    EXPECT_EQ(complaint_about("[load]", "[load]\nsteps = 0"), "case.toml:25: load.steps = 0 must be >= 2");
    EXPECT_EQ(complaint_about("units = \"N-mm-MPa\"", "units = \"SI\""),
              "case.toml:2: units = \"SI\" must be \"N-mm-MPa\"");
    EXPECT_EQ(complaint(complete + "[fine]\nguard = \"stop\"\n"),
              "case.toml:27: fine.guard = \"stop\" must be one of extend, warn");
}

TEST_F(CaseFile, PointsAtTheLineOfAWrongType) {
    EXPECT_EQ(complaint_about("size = 5.0", "size = \"big\""), "case.toml:7: mesh.size = \"big\" must be a number");
    EXPECT_EQ(complaint_about("width = 50.0", "width = 2020-01-01"),
              "case.toml:5: mesh.width = (a date or time) must be a number");
    EXPECT_EQ(complaint_about("[load]", "[load]\nsteps = 4.5"),
              "case.toml:25: load.steps = 4.5 must be a whole number");
    EXPECT_EQ(complaint_about("traction = [0.0, 1.0]", "traction = [0.0]"),
              "case.toml:19: boundary.0.traction = [0.0] must be two numbers [x, y]");
    EXPECT_EQ(complaint_about("[\"free\", 0.0]", "[\"fixed\", 0.0]"),
              "case.toml:23: boundary.1.displacement = \"fixed\" must be two entries, each a number or \"free\"");
    EXPECT_EQ(complaint_about("{ friction = 0.0 }", "true"),
              "case.toml:16: crack.0.contact = true must be a table { key = value, ... }");
}

TEST_F(CaseFile, NamesWhatIsMissing) {
    EXPECT_EQ(complaint_about("young = 200e3\n", ""), "case.toml:9: material.young is missing: Young's modulus.");
    EXPECT_EQ(complaint_about("units = \"N-mm-MPa\"\n", ""),
              "case.toml:1: units is missing: the only system of units, units = \"N-mm-MPa\".");
    EXPECT_EQ(complaint("units = \"N-mm-MPa\"\n"), "case.toml:1: mesh needs specimen or file");
    EXPECT_EQ(complaint_about("width = 50.0\n", ""), "case.toml:3: mesh.width is missing: a specimen needs it");
    EXPECT_EQ(complaint_about("blocks = [ { max = 50.0, ratio = -1.0 } ]\n", ""),
              "case.toml:24: load.blocks is empty, but boundary \"top\" carries a load: give at least one block");
}

TEST_F(CaseFile, NamesTheNearestKnownKey) {
    EXPECT_EQ(complaint_about("yield_stress", "yeild_stress"),
              "case.toml:12: material.yeild_stress is not a known key; did you mean material.yield_stress?");
    EXPECT_EQ(complaint_about("[material]", "[materail]"),
              "case.toml:9: materail is not a known key; did you mean material?");
    EXPECT_EQ(complaint_about("size = 5.0", "size = 5.0\nthickness = 2.0"),
              "case.toml:8: mesh.thickness is not a known key; did you mean model.thickness?");
    EXPECT_EQ(complaint_about("size = 5.0", "size = 5.0\ncolour = 2.0"),
              "case.toml:8: mesh.colour is not a known key; mesh has specimen, file, width, height, size, grading");
}

TEST_F(CaseFile, RefusesWhatKeysSayTogether) {
    EXPECT_EQ(complaint_about("ratio = -1.0", "ratio = -1.0, min = 0.0"),
              "case.toml:25: load.blocks.0 has both ratio and min; one of them says it");
    EXPECT_EQ(complaint_about(", ratio = -1.0", ""), "case.toml:25: load.blocks.0 needs ratio or min");
    EXPECT_EQ(complaint_about("ratio = -1.0", "min = 60.0"),
              "case.toml:25: load.blocks.0.min = 60 must keep the minimum < max: there is no cycle otherwise");
    EXPECT_EQ(
        complaint_about("[20.0, 100.0]]", "[0.0, 100.0]]"),
        "case.toml:15: crack.0.points = [[0.0, 100.0], [0.0, 100.0]] must not repeat a point: a segment has no length");
    EXPECT_EQ(complaint_about(", [20.0, 100.0]]", "]"),
              "case.toml:15: crack.0.points = [[0.0, 100.0]] must have at least two points");
    EXPECT_NE(complaint(complete, {"crack.0.contact.smooth=[1.0, 2.0]", "crack.0.contact.friction=0.0"})
                  .find("needs friction > 0 outside of them"),
              std::string::npos);
    for (const std::string smooth : {"[3.0]", "[3.0, 2.0]", "[-1.0, 2.0]"})
        EXPECT_NE(complaint(complete, {"crack.0.contact.smooth=" + smooth})
                      .find("must be two arc lengths, the first at least 0 and the second larger"),
                  std::string::npos)
            << complaint(complete, {"crack.0.contact.smooth=" + smooth});
    EXPECT_EQ(complaint_about("at = [25.0, 0.0]\n", ""), "case.toml:20: boundary.1 on = \"point\" needs at = [x, y]");
}

// Tables within tables are walked through by recursion.
TEST_F(CaseFile, RefusesWhatIsNoCaseFile) {
    std::string deep = "a";
    for (int k = 0; k < 100'000; ++k) deep += ".a";
    EXPECT_EQ(complaint(complete + deep + " = 1\n"), "case.toml:26: a key of more than 50 parts");
    EXPECT_EQ(complaint(complete, {deep + "=1"}), "--set:1: a key of more than 50 parts");
    EXPECT_EQ(complaint("title = \"" + std::string(1000, '.') + "\"\n" + complete.substr(complete.find("units"))),
              "accepted");
    EXPECT_THROW(read_case("/dev/zero"), CaseError);
    const std::string pipe = (folder_ / "pipe").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(read_case(pipe), CaseError);
}

TEST_F(CaseFile, SaysPlainlyWhatThisVersionHasNot) {
    for (const char* passage : {"[regions]\nsteel = \"a\"\n", "[material.steel]\nyoung = 1.0\n"})
        EXPECT_NE(complaint(complete + passage).find("is not available in this version"), std::string::npos) << passage;
}

TEST_F(CaseFile, PointsAtErrorsOfSyntax) {
    EXPECT_EQ(complaint("title = \"a\"\nunits = = 3\n").substr(0, 15), "case.toml:2:9: ");
    EXPECT_EQ(complaint("title = \"a\"\ntitle = \"b\"\n").substr(0, 12), "case.toml:2:");
    EXPECT_EQ(complaint("[=\n").find('\n'), std::string::npos);
    EXPECT_THROW(read_case((folder_ / "none.toml").string()), CaseError);
    EXPECT_THROW(read_case(folder_.string()), CaseError);
}

TEST_F(CaseFile, TakesOverrides) {
    const Case scene =
        read(complete, {"fine.beta=4", "mesh.specimen=plate", "load.blocks=[{max=1.0, min=0.5, cycles=3}]",
                        "crack.0.notch = 15", "name=other"});
    EXPECT_EQ(scene.fine.beta, 4.0);
    EXPECT_EQ(scene.mesh.specimen, "plate");
    EXPECT_EQ(scene.load.blocks, (std::vector<LoadBlock>{{.cycles = 3, .max = 1.0, .min = 0.5}}));
    EXPECT_EQ(scene.cracks.at(0).notch, 15.0);
    EXPECT_EQ(scene.name, "other");
}

TEST_F(CaseFile, PointsAtOverridesThatAreWrong) {
    EXPECT_EQ(complaint(complete, {"fine.beta=-4"}), "--set: fine.beta = -4 must be > 0");
    EXPECT_EQ(complaint(complete, {"fine.beat=4"}), "--set: fine.beat is not a known key; did you mean fine.beta?");
    EXPECT_EQ(complaint(complete, {"material.yield=300"}),
              "--set: material.yield is not a known key; did you mean material.yield_stress?");
    EXPECT_EQ(complaint(complete, {"fine.beta"}), "--set fine.beta: must be key=value");
    EXPECT_EQ(complaint(complete, {"crack.1.notch=1"}),
              "--set crack.1.notch=1: \"1\" is no entry of a list of 1, counted from 0");
    EXPECT_EQ(complaint(complete, {"load.blocks=[1,"}).substr(0, 23), "--set load.blocks=[1,: ");
}

TEST(CaseReference, FirstExampleIsValid) {
    const Case scene = read_case(std::string(test::source_folder) + "/cases/sent-compression/case.toml");
    EXPECT_EQ(scene.name, "sent-compression");
    EXPECT_EQ(scene.load.blocks.at(0).min, -50.0);
}

}  // namespace
}  // namespace stria::test
