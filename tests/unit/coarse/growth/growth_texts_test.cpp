#include "coarse/growth/growth_texts.hpp"

#include <gtest/gtest.h>

namespace stria::coarse {
namespace {

TEST(GrowthTexts, NameTipsThatTurnAsIfTheirFacesPassedThroughEachOther) {
    const std::vector<TipResult> directs{{.K_I = 10.0, .K_II = 10.0}};
    const TipResult blind{.K_I = 12.0, .K_II = 2.0, .K_I_of_wake = 2.0, .rings_flow = true, .contact_length = 0.1};
    const auto texts = [&](const TipResult& reached, GrowthDirection direction = GrowthDirection::HoopStress) {
        return turn_blindly(direction, directs, {reached});
    };
    ASSERT_EQ(texts(blind).size(), 1U);
    EXPECT_NE(texts(blind)[0].find("tip 0: its faces touch"), std::string::npos);
    EXPECT_NE(texts(blind)[0].find("by -53 degrees"), std::string::npos);
    EXPECT_NE(texts(blind)[0].find("would by -21"), std::string::npos);
    EXPECT_TRUE(texts(blind, GrowthDirection::Straight).empty());
    TipResult other = blind;
    other.rings_flow = false;
    EXPECT_TRUE(texts(other).empty());
    other = blind;
    other.contact_length = 0.0;
    EXPECT_TRUE(texts(other).empty());
    other = blind;
    other.K_II = 9.0;
    EXPECT_TRUE(texts(other).empty());
}

}  // namespace
}  // namespace stria::coarse
