// Materials that are no metals: who has typed GPa, or Pa, learns it before the run.
#include "coarse/advice/material_adequacy.hpp"

#include <gtest/gtest.h>

namespace stria::test {
namespace {

Case metal(double young, double yield_stress) {
    Case input;
    input.material.young = young;
    input.material.yield_stress = yield_stress;
    return input;
}

/// The one sentence that is said.
std::string warning_of(const Case& input) {
    const std::vector<std::string> warnings = coarse::material_warnings(input);
    return warnings.size() == 1 ? warnings[0] : std::to_string(warnings.size()) + " warnings";
}

TEST(MaterialAdequacy, TakesEveryMetalAsItIs) {
    EXPECT_TRUE(coarse::material_warnings(metal(16e3, 5.0)).empty()) << "lead";
    EXPECT_TRUE(coarse::material_warnings(metal(200e3, 300.0)).empty());
    EXPECT_TRUE(coarse::material_warnings(metal(95e3, 1900.0)).empty()) << "a metallic glass";
    Case elastic = metal(200.0, 300.0);
    elastic.material.yield_stress.reset();
    EXPECT_TRUE(coarse::material_warnings(elastic).empty());
}

TEST(MaterialAdequacy, AsksForTheUnitsOfOthers) {
    EXPECT_EQ(warning_of(metal(200.0, 300.0)),
              "material: yield_stress / young = 1.5 is a strain at which no metal yields (1e-4 to 0.02): are both in "
              "MPa?");
    EXPECT_TRUE(warning_of(metal(200e9, 300.0)).ends_with("Increments of many times that strain take long"));
}

TEST(MaterialAdequacy, NamesAMetalThatSoftensByMoreThanItHardens) {
    Case input = metal(200e3, 300.0);
    input.material.isotropic = {.law = HardeningLaw::Voce, .Q = -100.0, .b = 20.0};
    EXPECT_TRUE(warning_of(input).starts_with("material: at a plastic strain of 1e-05 it softens by more than it "
                                              "hardens, by 2e+03 MPa: "))
        << warning_of(input);
    input.material.kinematic = {{60e3, 300.0}};  // 60e3 exp(-300 p) - 2000 exp(-20 p): least at p = 0.0218
    EXPECT_NE(warning_of(input).find("at a plastic strain of 0.022 it softens"), std::string::npos)
        << warning_of(input);
    EXPECT_NE(warning_of(input).find("by 1.21e+03 MPa"), std::string::npos) << warning_of(input);
    input.material.kinematic.push_back({1200.0, 0.0});  // 12 MPa are missing, which is nothing
    EXPECT_TRUE(coarse::material_warnings(input).empty());
    input.material.kinematic = {{60e3, 300.0, true}};  // up to p = 1 / gamma
    EXPECT_NE(warning_of(input).find("at a plastic strain of 0.0034"), std::string::npos) << warning_of(input);
}

// Barsom and Rolfe's law of ferritic steels, 6.9e-12 m/cycle and MPa sqrt(m), m = 3: 2.18e-13 in mm and MPa sqrt(mm).
TEST(MaterialAdequacy, AsksForTheUnitsOfALawOfGrowth) {
    Case input = metal(200e3, 300.0);
    input.growth = GrowthSection{.law = GrowthLaw::Paris, .increment = 0.1, .C = 2.18e-13, .m = 3.0};
    const std::vector<double> K{20.0, 600.0};
    EXPECT_TRUE(coarse::rate_warnings(input, K, K).empty());
    EXPECT_TRUE(coarse::rate_warnings(input, {}, {}).empty());
    EXPECT_TRUE(coarse::rate_warnings(input, {0.0}, {0.0}).empty());
    input.growth->C = 6.9e-9;  // mm/cycle, MPa sqrt(m)
    ASSERT_EQ(coarse::rate_warnings(input, K, K).size(), 1U);
    EXPECT_NE(coarse::rate_warnings(input, K, K)[0].find("da/dN = 1.5 mm, and no crack grows so fast"),
              std::string::npos)
        << coarse::rate_warnings(input, K, K)[0];
    EXPECT_NE(coarse::rate_warnings(input, K, K)[0].find("MPa sqrt(m), growth.C = 2.18e-13; if"), std::string::npos);
    input.growth->C = 2.18e-19;
    EXPECT_NE(coarse::rate_warnings(input, K, K)[0].find("so slowly"), std::string::npos);
    EXPECT_EQ(coarse::rate_warnings(input, K, K)[0].find("growth.C ="), std::string::npos) << "slower still";
    input.growth->m = 4096.0;
    EXPECT_NE(coarse::rate_warnings(input, K, K)[0].find("da/dN = inf mm"), std::string::npos);
    EXPECT_EQ(coarse::rate_warnings(input, K, K)[0].find("growth.C ="), std::string::npos) << "that would be 0";
    input.growth->m = 3.0;
    input.growth->law = GrowthLaw::Prescribed;
    EXPECT_TRUE(coarse::rate_warnings(input, K, K).empty());
}

TEST(MaterialAdequacy, SaysWhereALawEnds) {
    Case input = metal(200e3, 300.0);
    input.growth =
        GrowthSection{.law = GrowthLaw::Paris, .increment = 0.1, .C = 2.18e-13, .m = 3.0, .threshold = 650.0};
    const auto said = [&] { return coarse::rate_warnings(input, {20.0, 600.0}, {20.0, 600.0}).at(0); };
    EXPECT_EQ(said(),
              "growth.threshold: no growth by a dK below 650 MPa sqrt(mm), and that of no tip is larger than 600");
    EXPECT_TRUE(coarse::rate_warnings(input, {600.0}, {700.0}).empty()) << "cycles that are rarer";
    input.growth->driving = GrowthDriving::FullRange;  // compression too
    EXPECT_TRUE(coarse::rate_warnings(input, {20.0, 600.0}, {20.0, 600.0}).empty());
    input.growth =
        GrowthSection{.law = GrowthLaw::Table, .increment = 0.1, .ranges = {200.0, 500.0}, .rates = {1e-6, 1e-4}};
    EXPECT_EQ(said(),
              "growth.ranges ends at dK = 500 MPa sqrt(mm), and that of a tip may be 600: the last line goes on");
    input.growth->ranges[1] = 700.0;
    EXPECT_TRUE(coarse::rate_warnings(input, {20.0, 600.0}, {20.0, 600.0}).empty());
    input.growth->rates = {1e-2, 1.0};
    EXPECT_TRUE(said().starts_with("growth.rates: at dK = 600 MPa sqrt(mm) the law gives da/dN = 0.57 mm")) << said();
}

// K_max was taken for dK: that of a threshold of 400 was to grow by a dK of 600 (1 - 0.4).
TEST(MaterialAdequacy, LooksAtTheRangeAndNotAtTheMaximum) {
    Case input = metal(200e3, 300.0);
    input.load.blocks = {{.cycles = 9, .max = 100.0, .min = 40.0}, {.cycles = 1, .max = 80.0, .min = 40.0}};
    input.growth =
        GrowthSection{.law = GrowthLaw::Paris, .increment = 0.1, .C = 2.18e-13, .m = 3.0, .threshold = 400.0};
    const auto said = [&] { return coarse::rate_warnings(input, {600.0}, {600.0}); };
    ASSERT_EQ(said().size(), 1U);
    EXPECT_TRUE(said()[0].ends_with("below 400 MPa sqrt(mm), and that of no tip is larger than 360")) << said()[0];
    input.growth->walker = 0.5;
    EXPECT_TRUE(said().empty()) << "465";
    input.growth->walker = 1.0;
    input.load_cases.resize(1);
    EXPECT_TRUE(said().empty()) << "nobody knows what it does to the minimum";
    input.load_cases.clear();
    input.load.blocks.push_back({.cycles = 1, .max = 50.0, .min = -50.0});
    EXPECT_TRUE(said().empty());
}

TEST(MaterialAdequacy, NamesTheRegion) {
    Case input = metal(200e3, 300.0);
    input.regions.resize(2);
    input.regions[0].material = input.regions[1].material = input.material;
    input.regions[1].material.young = 1e9;
    EXPECT_TRUE(warning_of(input).starts_with("region.1.material: ")) << warning_of(input);
}

}  // namespace
}  // namespace stria::test
