#include "common/case/schema/case_file.hpp"

#include "common/case/case_questions.hpp"
#include "common/error.hpp"
#include "common/memory.hpp"
#include "tests/support/folders.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

namespace stria {
namespace {

// Line numbers in the tests count from the `title`, line 1.
const std::string complete = R"(title = "a plate"
units = "N-mm-MPa"
[mesh]
specimen = "sent"
width = 50.0
height = 200
size = 5.0
grading = [ { at = [20.0, 100.0], size = 0.1, outer_size = 0.2, radius = 3.0 } ]
[material]
young = 200e3
poisson = 0.3
yield_stress = 300.0
kinematic = [ { C = 4000.0 } ]
[[crack]]
points = [[0.0, 100.0], [20.0, 100.0]]
contact = { friction = 0.0 }
[[boundary]]
on = "top"
traction = [0.0, 1.0]
[[boundary]]
on = "point"
at = [25.0, 0.0]
displacement = ["free", 0.0]
[load]
blocks = [ { max = 50.0, ratio = -1.0 } ]
)";

std::string text_of(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

class CaseFile : public testing::Test {
protected:
    void SetUp() override {
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        folder_ = std::filesystem::temp_directory_path() / ("stria-" + test + "-" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_ / "plate");
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    Case read(const std::string& text, const std::vector<std::string>& overrides = {}) {
        path_ = (folder_ / "plate" / "case.toml").string();
        std::ofstream(path_) << text;
        return read_case(path_, overrides);
    }

    /// The complaint about the text, without the folder in front.
    std::string complaint(const std::string& text, const std::vector<std::string>& overrides = {}) {
        try {
            read(text, overrides);
        } catch (const CaseError& error) {
            const std::string what = error.what();
            const std::size_t start = what.find(path_);
            return start == 0 ? what.substr(path_.size() - std::string("case.toml").size()) : what;
        }
        return "no complaint";
    }

    /// The complaint when one passage of the complete case reads otherwise.
    std::string complaint_about(const std::string& passage, const std::string& replacement) {
        std::string text = complete;
        const std::size_t at = text.find(passage);
        EXPECT_NE(at, std::string::npos) << passage;
        return complaint(text.replace(at, passage.size(), replacement));
    }

    std::filesystem::path folder_;
    std::string path_;
};

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

TEST_F(CaseFile, KnowsTheProportionsOfSpecimens) {
    std::string text = complete;
    const std::string height = "height = 200\n";
    text.erase(text.find(height), height.size());
    EXPECT_EQ(read(text).mesh.height, 200.0);
    EXPECT_EQ(read(text, {"mesh.specimen=mt"}).mesh.height, 150.0);
    EXPECT_EQ(read(text, {"mesh.specimen=ct"}).mesh.height, 60.0);
    EXPECT_NE(resolved_toml(read(text)).find("height = 200"), std::string::npos);
    EXPECT_EQ(complaint(text, {"mesh.specimen=plate"}),
              "case.toml:3: mesh needs height: a plate has no standard proportions");
    EXPECT_EQ(complaint(complete, {"mesh.specimen=ct"}),
              "case.toml:6: mesh.height = 200 mm must be 1.2 width, or be left out");
}

TEST_F(CaseFile, TakesForcesAtPins) {
    const std::string pin = "[[boundary]]\non = \"pin-top\"\n";
    EXPECT_EQ(read(complete + pin + "force = [0.0, 1.0]\n").boundaries.back().force, Vec2(0.0, 1.0));
    EXPECT_NE(complaint(complete + pin + "displacement = [\"free\", 1.0]\n").find("a pin turns freely"),
              std::string::npos);
    EXPECT_NE(complaint(complete + pin + "traction = [0.0, 1.0]\n").find("not a point"), std::string::npos);
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

TEST_F(CaseFile, AnOpeningRangeIsReadSomewhere) {
    const std::string grows = std::string(complete) + "[growth]\nlaw = \"ctod\"\nincrement = 0.1\nC = 1.0\nm = 2.0\n";
    EXPECT_EQ(complaint(grows),
              "case.toml:27: growth.law = \"ctod\" needs closure.distance: how far behind the tip the "
              "opening is read");
    EXPECT_EQ(read(grows + "[closure]\ndistance = 0.2\n").closure.distance, 0.2);
}

TEST_F(CaseFile, AComplianceNeedsIncrementsOfANumber) {
    const std::string offset = std::string(complete) + "[closure]\ndefinition = \"offset\"\n";
    EXPECT_NE(complaint(offset, {"load.steps=\"auto\""}).find("closure.definition = \"offset\" needs load.steps, "),
              std::string::npos);
    EXPECT_EQ(read(offset, {"load.steps=40"}).closure.definition, OpeningDefinition::Offset);
}

TEST_F(CaseFile, GrowsByATableOrAPowerWithAThreshold) {
    const auto growing = [](const std::string& keys) {
        return std::string(complete) + "[growth]\nincrement = 0.1\n" + keys;
    };
    const Case scene = read(growing("law = \"table\"\nranges = [60.0, 400.0]\nrates = [1e-8, 1e-5]\n"));
    EXPECT_EQ(scene.growth->ranges, (std::vector<double>{60.0, 400.0}));
    EXPECT_EQ(read(resolved_toml(scene)), scene);
    EXPECT_EQ(read(growing("law = \"paris\"\nC = 1e-13\nm = 3.0\nthreshold = 63.0\n")).growth->threshold, 63.0);
    for (const char* curve :
         {"ranges = [60.0, 400.0]\nrates = [1e-8]\n", "ranges = [60.0]\nrates = [1e-8]\n", "",
          "ranges = [400.0, 60.0]\nrates = [1e-8, 1e-5]\n", "ranges = [60.0, 400.0]\nrates = [1e-8, 1e-8]\n",
          "ranges = [0.0, 400.0]\nrates = [1e-8, 1e-5]\n"})
        EXPECT_EQ(
            complaint(growing(std::string("law = \"table\"\n") + curve)),
            "case.toml:28: growth.law = \"table\" needs ranges and rates, as long, with two numbers at least, both "
            "positive and ascending")
            << curve;
    EXPECT_EQ(complaint(growing("law = \"table\"\nm = 3.0\nranges = [60.0, 400.0]\nrates = [1e-8, 1e-5]\n")),
              "case.toml:29: growth.m = 3 belongs to law = \"paris\" or \"ctod\"");
    EXPECT_EQ(complaint(growing("threshold = 63.0\n")),
              "case.toml:28: growth.threshold = 63 belongs to law = \"paris\"");
    EXPECT_EQ(complaint(growing("rates = [1e-8]\n")),
              "case.toml:28: growth.rates = [1e-08] belongs to law = \"table\"");
    EXPECT_EQ(complaint(growing("walker = 0.5\n")),
              "case.toml:28: growth.walker = 0.5 belongs to law = \"paris\" or \"table\" with driving = \"dK\"");
    EXPECT_EQ(complaint(growing("walker = 0.5\nlaw = \"paris\"\nC = 1e-13\nm = 3.0\ndriving = \"dK_full\"\n")),
              "case.toml:28: growth.walker = 0.5 belongs to law = \"paris\" or \"table\" with driving = \"dK\"");
    EXPECT_EQ(read(growing("walker = 0.5\nlaw = \"paris\"\nC = 1e-13\nm = 3.0\n")).growth->walker, 0.5);
}

TEST_F(CaseFile, AnIncrementOfGrowthIsANumberOrAuto) {
    const auto growing = [](const std::string& law, const std::string& more) {
        return std::string(complete) + "[growth]\nlaw = \"" + law + "\"\n" + more;
    };
    const std::string rate = "C = 1e-12\nm = 3.0\n";
    const Case scene = read(growing("paris", rate + "increment = \"auto\"\nzone_fraction = 0.1\n"));
    EXPECT_TRUE(scene.growth->increment.is_auto());
    EXPECT_EQ(scene.growth->zone_fraction, 0.1);
    EXPECT_EQ(read(resolved_toml(scene)), scene);
    const Case given = read(growing("paris", rate + "increment = 0.1\n"));
    EXPECT_EQ(given.growth->increment, 0.1);
    EXPECT_EQ(read(resolved_toml(given)), given);
    EXPECT_EQ(complaint(growing("paris", rate + "increment = \"some\"\n")),
              "case.toml:30: growth.increment = \"some\" must be number or \"auto\"");
    EXPECT_EQ(complaint(growing("paris", rate + "increment = -0.1\n")),
              "case.toml:30: growth.increment = -0.1 mm must be > 0");
    EXPECT_EQ(complaint(growing("prescribed", "increment = \"auto\"\n")),
              "case.toml:28: growth.increment = \"auto\" needs law = \"paris\", \"table\" or \"ctod\"");
}

const std::string two_regions = R"(
[[region]]
outline = [[0.0, 0.0], [50.0, 20.0]]
material = { young = 70e3, poisson = 0.33 }
initial_stress = { yy = 12.0 }
[[region]]
outline = [[0.0, 30.0], [9.0, 30.0], [0.0, 40.0]]
[region.material]
young = 1e3
poisson = 0.4
yield_stress = 20.0
[initial_stress]
sigma_y = { at = [0.0, 25.0, 50.0], stress = [1.0, -1.0, 1.0] }
file = "grid.csv"
)";

TEST_F(CaseFile, ReadsRegionsAndTheirStress) {
    std::ofstream(folder_ / "plate" / "grid.csv")
        << "x,y,sxx,syy,sxy\n0,0,1,2,3\n50,0,1,2,3\n0,200,1,2,3\n50,200,1,2,4\n";
    const Case scene = read(complete + two_regions);
    ASSERT_EQ(scene.regions.size(), 2U);
    EXPECT_FALSE(scene.regions[0].material.yield_stress);
    EXPECT_EQ(scene.regions[0].initial_stress->yy, 12.0);
    EXPECT_EQ(scene.regions[1].outline.size(), 3U);
    EXPECT_EQ(scene.regions[1].material.yield_stress, 20.0);
    EXPECT_FALSE(scene.initial_stress->file);
    EXPECT_EQ(scene.initial_stress->grid->xy.back(), 4.0);
    const std::string resolved = resolved_toml(scene);
    EXPECT_EQ(read(resolved), scene);
    Case other = scene;
    other.regions[0].material.poisson = 0.34;
    EXPECT_NE(digest(other), digest(scene));
    other = scene;
    other.initial_stress->grid->xy.back() = 5.0;
    EXPECT_NE(digest(other), digest(scene));
}

TEST_F(CaseFile, RefusesRegionsAndStressThatAreNone) {
    const auto with = [&](const std::string& passage, const std::string& replacement) {
        std::string text = complete + two_regions;
        return complaint(text.replace(text.find(passage), passage.size(), replacement));
    };
    EXPECT_EQ(with("material = { young = 70e3, poisson = 0.33 }\n", ""),
              "case.toml:27: region.0.material.young is missing: Young's modulus.");
    EXPECT_EQ(with("[50.0, 20.0]", "[0.0, 20.0]"),
              "case.toml:28: region.0.outline = [[0.0, 0.0], [0.0, 20.0]] must be two opposite corners: the rectangle "
              "has no area");
    EXPECT_EQ(with("[9.0, 30.0], [0.0, 40.0]", "[9.0, 30.0], [0.0, 40.0], [9.0, 40.0]"),
              "case.toml:32: region.1.outline = [[0.0, 30.0], [9.0, 30.0], [0.0, 40.0], [9.0, 40.0]] must not cross or "
              "touch itself");
    EXPECT_EQ(with("at = [0.0, 25.0, 50.0]", "at = [0.0, 25.0, 20.0]"),
              "case.toml:38: initial_stress.sigma_y.at = [0.0, 25.0, 20.0] must be two or more, ascending");
    EXPECT_EQ(with("stress = [1.0, -1.0, 1.0]", "stress = [1.0, -1.0]"),
              "case.toml:38: initial_stress.sigma_y.stress = [1.0, -1.0] must have one number per place of at");
    EXPECT_EQ(complaint(complete + "[initial_stress]\n"),
              "case.toml:26: initial_stress needs sigma_x, sigma_y, file or grid");
    EXPECT_NE(with("file = \"grid.csv\"", "file = \"nowhere.csv\"").find("initial_stress.file: cannot be read"),
              std::string::npos);
    EXPECT_NE(complaint(complete + "[regions]\nsteel = [[0, 0], [1, 1]]\n").find("[[region]]"), std::string::npos);
}

// A body is a specimen with its sizes, or a file whose groups have names.
TEST_F(CaseFile, TakesItsMeshFromAFile) {
    std::string text = complete;
    const std::size_t from = text.find("specimen"), to = text.find("[material]");
    text.replace(from, to - from,
                 "file = \"../part.msh\"\n[[region]]\ngroup = \"weld\"\n[region.material]\nyoung = 1e5\n"
                 "poisson = 0.3\n");
    const Case scene = read(text, {"boundary.0.on=pin-top"});
    EXPECT_EQ(scene.mesh.file, (folder_ / "part.msh").string());
    EXPECT_EQ(scene.regions.at(0).group, "weld");
    const std::string resolved = resolved_toml(scene);
    EXPECT_EQ(resolved.find("specimen = "), std::string::npos);
    EXPECT_EQ(resolved.find("outline = "), std::string::npos);
    EXPECT_EQ(read(resolved), scene);
    EXPECT_EQ(complaint(text, {"mesh.size=2"}),
              "--set: mesh.size belongs to a specimen; the mesh is that of mesh.file");
    EXPECT_EQ(complaint(text, {"region.0.outline=[[0, 0], [1, 1]]"}),
              "case.toml:5: region.0 needs outline or group, one of them");
    EXPECT_EQ(complaint(complete + "[[region]]\ngroup = \"weld\"\n[region.material]\nyoung = 1e5\npoisson = 0.3\n"),
              "case.toml:27: region.0.group = \"weld\" needs mesh.file, whose groups have names");
}

TEST_F(CaseFile, RefusesARunThatWouldDoNothing) {
    EXPECT_EQ(complaint_about("ratio = -1.0", "ratio = 1.0"),
              "case.toml:25: load.blocks.0.ratio = 1 must keep the minimum < max: there is no cycle otherwise");
    EXPECT_EQ(complaint_about("traction = [0.0, 1.0]", "traction = [0.0, 0.0]"),
              "case.toml:1: boundary carries no load: give one a displacement, traction, pressure or force other than "
              "zero");
    EXPECT_EQ(complaint_about("traction = [0.0, 1.0]", "displacement = [0.0, 0.0]").substr(0, 33),
              "case.toml:1: boundary carries no ");
}

TEST_F(CaseFile, RefusesLoadsBeyondAllUse) {
    EXPECT_EQ(complaint_about("[load]", "[load]\nscale = 5e-324"),
              "case.toml:25: load.scale makes a max or min beyond all use: its size must lie between 1e-100 and 1e100, "
              "or be zero");
    EXPECT_NE(complaint(complete, {"load.blocks.0.max=1e300"}).find("beyond all use"), std::string::npos);
    EXPECT_EQ(complaint_about("{ max", "{ cycles = 1000000000, max"),
              "case.toml:24: load has 1e+09 cycles of 12 increments, at most 2147483647 increments can be counted");
    if (available_memory() < 1e11) {
        EXPECT_EQ(complaint(complete, {"load.steps=2", "load.repeat=500000000"}).substr(0, 55),
                  "case.toml:24: load: 5e+08 cycles would take about 100 G");
    }
    EXPECT_EQ(complaint(complete, {"fine.subcells=65536"}), "--set: fine.subcells = 65536 must be <= 256");
}

// Tables within tables are walked through by recursion.
TEST_F(CaseFile, RefusesWhatIsNoCaseFile) {
    std::string deep = "a";
    for (int k = 0; k < 100'000; ++k) deep += ".a";
    EXPECT_EQ(complaint(complete + deep + " = 1\n"), "case.toml:26: a key of more than 50 parts");
    EXPECT_EQ(complaint(complete, {deep + "=1"}), "--set:1: a key of more than 50 parts");
    EXPECT_EQ(complaint("title = \"" + std::string(1000, '.') + "\"\n" + complete.substr(complete.find("units"))),
              "no complaint");
    EXPECT_THROW(read_case("/dev/zero"), CaseError);
    const std::string pipe = (folder_ / "pipe").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(read_case(pipe), CaseError);
}

TEST_F(CaseFile, RefusesACrackOfTooManyPoints) {
    std::string points = "[[0.0, 100.0]";
    for (int k = 1; k <= 10'000; ++k) points += ", [" + std::to_string(0.002 * k) + ", 100.0]";
    EXPECT_EQ(complaint_about("[[0.0, 100.0], [20.0, 100.0]]", points + "]"),
              "case.toml:15: crack.0.points has 10001 points, at most 10000 are allowed");
}

TEST_F(CaseFile, DisplacementControlNeedsALoad) {
    EXPECT_EQ(read(complete, {"load.control=displacement"}).load.control, Control::Displacement);
    EXPECT_EQ(complaint(complete, {"load.control=displacement", "boundary.0.displacement=[\"free\", 1.0]"}),
              "--set: load.control = \"displacement\" needs a load on the first boundary that is driven: \"top\" has a "
              "displacement of its own, which control = \"load\" scales");
    const std::string held = complete.substr(0, complete.find("traction")) + "displacement = [0.0, 0.0]\n" +
                             complete.substr(complete.find("[load]")) + "control = \"displacement\"\n";
    EXPECT_EQ(complaint(held), "case.toml:22: load.control = \"displacement\" needs a boundary that carries a load");
    EXPECT_EQ(complaint(complete + "control = \"stroke\"\n").substr(0, 44),
              "case.toml:26: load.control = \"stroke\" must b");
}

TEST_F(CaseFile, TakesFriction) {
    EXPECT_EQ(read(complete, {"crack.0.contact.friction=0.2"}).cracks[0].contact->friction, 0.2);
    EXPECT_EQ(complaint_about("friction = 0.0", "friction = -0.2"),
              "case.toml:16: crack.0.contact.friction = -0.2 must be >= 0");
}

TEST_F(CaseFile, SaysPlainlyWhatThisVersionHasNot) {
    for (const char* passage : {"[regions]\nsteel = \"a\"\n", "[material.steel]\nyoung = 1.0\n"})
        EXPECT_NE(complaint(complete + passage).find("is not available in this version"), std::string::npos) << passage;
}

TEST_F(CaseFile, TakesHardeningThatSaturates) {
    const Case input = read(complete + "[material.isotropic]\nlaw = \"voce\"\nQ = 90.0\nb = 12.0\n",
                            {"material.kinematic.0.gamma=50"});
    EXPECT_EQ(input.material.isotropic.Q, 90.0);
    EXPECT_EQ(input.material.kinematic.at(0).gamma, 50.0);
    const auto about = [&](const std::string& keys) { return complaint(complete + "[material.isotropic]\n" + keys); };
    for (const char* keys : {"law = \"voce\"\nQ = 90.0\n", "law = \"voce\"\nb = 3.0\n"})
        EXPECT_EQ(about(keys), "case.toml:26: material.isotropic needs a Q other than 0 and b > 0");
    EXPECT_EQ(about("law = \"voce\"\nQ = -299.0\nb = 3.0\n"), "no complaint");
    EXPECT_NE(about("law = \"voce\"\nQ = -300.0\nb = 3.0\n").find("needs a Q above -yield_stress"), std::string::npos);
    EXPECT_NE(about("law = \"voce\"\nQ = -200.0\nb = 100.0\n").find("needs a Q b above"), std::string::npos);
    EXPECT_EQ(about("Q = 90.0\n"), "case.toml:27: material.isotropic.Q = 90 belongs to law = \"voce\"");
    for (const char* keys :
         {"law = \"power\"\nn = 0.5\nalpha = 1.0\n", "law = \"power\"\nn = 900.0\nalpha = 1.0\nreference = 700.0\n",
          "law = \"table\"\nplastic_strain = [0.0, 0.1]\nstress = [300.0]\n",
          "law = \"table\"\nplastic_strain = [0.0, 0.1]\nstress = [300.0, 290.0]\n",
          "law = \"table\"\nplastic_strain = [0.0, 0.1]\nstress = [200.0, 290.0]\n"})
        EXPECT_NE(about(keys).find("material.isotropic needs"), std::string::npos) << keys;
}

TEST_F(CaseFile, RefinementNeedsARadiusWhereNothingYields) {
    const std::string plastic = "yield_stress = 300.0\n";
    std::string elastic = complete;
    elastic.erase(elastic.find(plastic), plastic.size());
    EXPECT_NE(complaint(elastic, {"fine.refine=8"}).find("fine.refine = 8 needs fine.radius"), std::string::npos);
    const auto accepted = [&](const std::string& text, const std::vector<std::string>& settings) {
        return complaint(text, settings).find("fine.refine") == std::string::npos;
    };
    EXPECT_TRUE(accepted(elastic, {"fine.refine=8", "fine.radius=2.0"}));
    EXPECT_TRUE(accepted(complete, {"fine.refine=8"}));
    EXPECT_FALSE(accepted(complete, {"fine.refine=3"}));
}

TEST_F(CaseFile, GeometricalEnrichmentIsForElasticTractionFreeScenes) {
    EXPECT_NE(
        complaint(complete + "[fine]\nenrichment = \"geometrical\"\n").find("fine.enrichment = \"geometrical\" is for"),
        std::string::npos);
    EXPECT_NE(
        complaint(complete + "[fine]\nenrichment = \"single\"\nenrichment_radius = 1.0\n").find("needs enrichment"),
        std::string::npos);
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

TEST(CaseReference, ExplainsEveryKey) {
    EXPECT_NE(explain("material.yield_stress").find("MPa; > 0; default absent"), std::string::npos);
    EXPECT_NE(explain("crack.0.contact.friction").find("Coulomb"), std::string::npos);
    EXPECT_NE(explain("mesh.file").find("Gmsh"), std::string::npos);
    EXPECT_NE(explain("").find("output.format"), std::string::npos);
    EXPECT_THROW(static_cast<void>(explain("material.yung")), CaseError);
}

TEST(CaseReference, DocumentIsUpToDate) {
    const std::filesystem::path document = std::filesystem::path(test::source_folder) / "docs/case-reference.md";
    EXPECT_TRUE(case_reference_markdown() == text_of(document))
        << "write it anew: stria explain --markdown > docs/case-reference.md";
}

TEST(CaseReference, FirstExampleIsValid) {
    const Case scene = read_case(std::string(test::source_folder) + "/cases/sent-compression/case.toml");
    EXPECT_EQ(scene.name, "sent-compression");
    EXPECT_EQ(scene.load.blocks.at(0).min, -50.0);
}

}  // namespace
}  // namespace stria
