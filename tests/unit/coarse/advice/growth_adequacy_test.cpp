// What begins and ends growth, typed in the units of others, or reached before it begins.
#include "coarse/advice/growth_adequacy.hpp"

#include <gtest/gtest.h>

namespace stria::test {
namespace {

Case that_grows(double young) {
    Case input;
    input.material.young = young;
    input.growth = GrowthSection{.law = GrowthLaw::Paris, .increment = 0.1, .C = 2e-13, .m = 3.0};
    return input;
}

using Sentences = std::vector<std::string>;

// Thresholds of 3 MPa sqrt(m) in steel and of 0.8 in aluminium at a high load ratio, toughness of a grey iron and of an
// aluminium: in MPa sqrt(mm), and as they are printed.
TEST(GrowthAdequacy, AsksForTheUnitsOfAThreshold) {
    Case steel = that_grows(200e3), aluminium = that_grows(70e3);
    EXPECT_TRUE(coarse::units_of_K_warnings(steel).empty()) << "none is given";
    steel.growth->threshold = 95.0;
    aluminium.growth->threshold = 25.0;
    EXPECT_TRUE(coarse::units_of_K_warnings(steel).empty());
    EXPECT_TRUE(coarse::units_of_K_warnings(aluminium).empty());
    steel.growth->threshold = 5.0;
    EXPECT_EQ(coarse::units_of_K_warnings(steel),
              (Sentences{"growth.threshold = 5 MPa sqrt(mm) is 0.16 MPa sqrt(m), less than that of any metal; if 5 is "
                         "meant in MPa sqrt(m), growth.threshold = 158.1"}));
    aluminium.growth->threshold = 3.0;
    EXPECT_EQ(coarse::units_of_K_warnings(aluminium).size(), 1U);
    steel.growth.reset();
    EXPECT_TRUE(coarse::units_of_K_warnings(steel).empty());
}

TEST(GrowthAdequacy, AsksForTheUnitsOfAToughness) {
    Case iron = that_grows(110e3), aluminium = that_grows(70e3);
    iron.growth->toughness = 380.0;
    aluminium.growth->toughness = 800.0;
    EXPECT_TRUE(coarse::units_of_K_warnings(iron).empty());
    EXPECT_TRUE(coarse::units_of_K_warnings(aluminium).empty());
    iron.growth->toughness = 12.0;
    aluminium.growth->toughness = 25.0;
    EXPECT_EQ(coarse::units_of_K_warnings(iron).size(), 1U);
    EXPECT_EQ(coarse::units_of_K_warnings(aluminium),
              (Sentences{"growth.toughness = 25 MPa sqrt(mm) is 0.79 MPa sqrt(m), less than that of any metal; if 25 "
                         "is meant in MPa sqrt(m), growth.toughness = 790.6"}));
    aluminium.regions.resize(1);
    aluminium.regions[0].material.young = 20e3;  // a tip in lead
    EXPECT_EQ(coarse::units_of_K_warnings(aluminium).size(), 0U);
}

TEST(GrowthAdequacy, SaysThatARunEndsBeforeItHasGrown) {
    Case input = that_grows(200e3);
    const auto said = [&] { return coarse::early_break_warnings(input, {400.0, 600.0}, {590.0, 0.0}); };
    EXPECT_TRUE(said().empty());
    input.growth->toughness = 650.0;
    EXPECT_TRUE(said().empty());
    input.growth->toughness = 600.0;
    EXPECT_EQ(said(), (Sentences{"growth.toughness = 600: K_max of tip 1 reaches 600 MPa sqrt(mm) before it has grown, "
                                 "and there the run ends"}));
    EXPECT_EQ(coarse::early_break_warnings(input, {400.0, 500.0}, {610.0, 500.0}),
              (Sentences{"growth.toughness = 600: K behind the turn that K_II makes of tip 0 reaches 610 MPa sqrt(mm) "
                         "before it has grown, and there the run ends"}));
    EXPECT_TRUE(coarse::early_break_warnings(input, {}, {}).empty()) << "no crack";
}

}  // namespace
}  // namespace stria::test
