// `stria material`: loop, table of cycles and chart of the case's material, and bad input.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "common/io/number_table.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

constexpr const char* fitted_plate = R"(
units = "N-mm-MPa"
mesh = { specimen = "sent", width = 20.0, height = 40.0, size = 2.0 }
crack = [ { points = [[0.0, 20.0], [8.0, 20.0]] } ]
boundary = [ { on = "top", traction = [0.0, 1.0] }, { on = "bottom", traction = [0.0, -1.0] } ]
load = { steps = 2, blocks = [ { cycles = 1, max = 10.0, ratio = 0.5 } ] }

[material]
young = 200e3
poisson = 0.3
yield_stress = 200.0
kinematic = [ { C = 62400.0, gamma = 300.0 } ]

[material_test]
control = "stress"
blocks = [ { cycles = 5, max = 300.0, min = -250.0 } ]
steps = 2000
)";

class Material : public testing::Test {
protected:
    int run(const Words& more, const std::string& text = fitted_plate) {
        std::ofstream(folder / "case.toml") << text;
        Words words{"material", folder / "case.toml", "-o", folder / "out"};
        words.insert(words.end(), more.begin(), more.end());
        return run_program("stria", words, folder / "log");
    }
    [[nodiscard]] std::string said() const { return text_of(folder / "log"); }
    void refuses(const Words& more, const std::string& because, const std::string& text = fitted_plate) {
        EXPECT_EQ(run(more, text), 2) << said();
        EXPECT_NE(said().find(because), std::string::npos) << said();
        EXPECT_EQ(std::ranges::count(said(), '\n'), 1) << said();
        EXPECT_FALSE(std::filesystem::exists(folder / "out/loop.csv"));
    }

    TemporaryFolder folder;
};

// references 6.5: it ratchets by (1/g) ln((L^2 - X_min^2) / (L^2 - X_max^2)) a cycle.
TEST_F(Material, LeavesTheLoopItsCyclesAndAChart) {
    ASSERT_EQ(run({}), 0) << said();
    const NumberTable loop = read_table(folder / "out/loop.csv"), cycles = read_table(folder / "out/cycles.csv");
    EXPECT_EQ(loop.rows, 1 + 11 * 1000);
    EXPECT_NEAR(*std::ranges::max_element(loop["stress"]), 300.0, 1e-6);
    EXPECT_NEAR(loop["plastic_strain"][1000], 2.18468951e-3, 1e-3 * 2.18468951e-3);
    ASSERT_EQ(cycles.rows, 5);
    const double ratchet = std::log((208.0 * 208.0 - 2500.0) / (208.0 * 208.0 - 10000.0)) / 300.0;
    for (const double own : cycles["ratchet_strain"]) EXPECT_NEAR(own, ratchet, 2e-3 * ratchet);
    const std::string chart = text_of(folder / "out/loop.svg");
    for (const char* part : {"<svg", "stress, MPa", "cycle 5", "</svg>"})
        EXPECT_NE(chart.find(part), std::string::npos) << part;
    for (const char* part : {"mean stress 25 MPa", "with increments half as large", "loop.csv"})
        EXPECT_NE(said().find(part), std::string::npos) << part << "\n" << said();
}

TEST_F(Material, KeepsWhatIsThereUnlessForced) {
    ASSERT_EQ(run({"--quiet", "--set", "material_test.steps=20"}), 0) << said();
    EXPECT_EQ(said(), "");
    EXPECT_EQ(run({}), 2);
    EXPECT_NE(said().find("--force overwrites it"), std::string::npos) << said();
    EXPECT_EQ(run({"--force", "--set", "material_test.control=strain", "--set",
                   "material_test.blocks=[{cycles=3, max=0.006, ratio=-1}]"}),
              0)
        << said();
    EXPECT_EQ(read_table(folder / "out/cycles.csv").rows, 3);
}

TEST_F(Material, RefusesWhatIsNoTest) {
    const std::string text = fitted_plate, without = text.substr(0, text.find("[material_test]"));
    refuses({}, "material_test is missing", without);
    refuses({}, "needs blocks", without + "[material_test]\nsteps = 10\n");
    refuses({"--set", "material_test.control=strain"}, "must be strains below 1, not percent");
    refuses({"--set", "material_test.steps=7"}, "material_test.steps = 7 must be");
    refuses({"--set", "material_test.mode=bending"}, "material_test.mode");
    refuses({"--set", "material_test.blocks=[{cycles=2, max=100.0}]"}, "needs ratio or min");
    refuses({"--set", "material.kinematic=[{C=1000.0, threshold=true}]"}, "needs gamma > 0");
    refuses({"--set", "material.kinematic=[{C=1000.0, C_start=5000.0, C_rate=10.0}]"}, "needs 2 gamma");
    refuses({"--set", "material.kinematic=[{C=1000.0, C_rate=10.0}]"}, "belongs to a C_start");
    std::string elastic = text;
    for (const char* key : {"yield_stress", "kinematic"}) elastic.insert(elastic.find(key), "# ");
    refuses({}, "an elastic material has no loop", elastic);
}

TEST_F(Material, EndsWhereTheMetalDoesNotBearTheStress) {
    EXPECT_EQ(run({"--set", "material_test.blocks=[{cycles=2, max=500.0, ratio=0.0}]"}), 3) << said();
    EXPECT_NE(said().find("no strain bears the stress"), std::string::npos) << said();
}

}  // namespace
}  // namespace stria::test
