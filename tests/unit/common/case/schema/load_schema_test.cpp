// The load history, and growth under it.
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

}  // namespace
}  // namespace stria::test
