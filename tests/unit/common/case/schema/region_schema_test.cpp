// Regions of other metals, and stress before any load.
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

}  // namespace
}  // namespace stria::test
