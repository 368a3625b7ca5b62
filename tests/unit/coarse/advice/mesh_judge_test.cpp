// That each doubt about the mesh at a tip is said when it arises, and once.
#include <gtest/gtest.h>

#include "coarse/advice/mesh_adequacy.hpp"
#include "coarse/specimen/specimen.hpp"
#include "tests/support/plate_that_flows.hpp"

namespace stria::test {
namespace {

using coarse::MeshJudge;
using Said = std::vector<std::string>;

class TipsJudged : public testing::Test {
protected:
    [[nodiscard]] Said look(MeshJudge& judge, double K_I, double distance = 1.3, double radius = 4.0) const {
        const BodyMesh mesh(coarse::make_mesh(input.mesh, input.cracks, input.regions));
        return judge.look_at(coarse::make_scene(input, mesh),
                             {.K_I = {K_I}, .distance = {distance}, .radius = {radius}});
    }
    Case input = plate_that_flows();
};

TEST_F(TipsJudged, AreSpokenOfOnceWhereTheirZoneHasShrunk) {
    MeshJudge judge;
    EXPECT_TRUE(look(judge, 2100.0).empty());
    const Said now = look(judge, 600.0);
    ASSERT_EQ(now.size(), 1U);
    EXPECT_NE(now[0].find("about 0.628 mm, spans 0.63 elements of 1 mm"), std::string::npos) << now[0];
    EXPECT_TRUE(look(judge, 2100.0).empty());
    EXPECT_TRUE(look(judge, 500.0).empty());
    MeshJudge goes_on(judge.said());
    EXPECT_TRUE(look(goes_on, 500.0).empty());
}

TEST_F(TipsJudged, AreSpokenOfForEachReason) {
    MeshJudge judge;
    EXPECT_EQ(look(judge, 600.0).size(), 1U);
    EXPECT_EQ(look(judge, 600.0, 1.1).size(), 1U) << "closure nearer than 1.2 elements";
    EXPECT_EQ(look(judge, 600.0, 1.1, 2.9).size(), 1U) << "no ring of three elements";
    EXPECT_TRUE(look(judge, 600.0, 1.1, 2.9).empty());
}

TEST_F(TipsJudged, GrowInPlaneStressByMoreThanATenthOfAZoneThatHasShrunk) {
    input.model.plane = PlaneState::Stress;
    input.growth = GrowthSection{.increment = 0.9};
    MeshJudge judge;
    EXPECT_TRUE(look(judge, 1700.0, 1.3).empty());  // 10.2 mm
    input.growth->increment = 1.0;
    EXPECT_TRUE(look(judge, 1700.0, 0.0).empty());
    const Said now = look(judge, 1650.0, 0.0);  // 9.63 mm
    ASSERT_EQ(now.size(), 2U);
    EXPECT_NE(now[0].find("opening loads want 10 or more: fine.refine = 2"), std::string::npos) << now[0];
    EXPECT_NE(now[1].find("growth.increment = 1 mm is 0.1 of its forward plastic zone"), std::string::npos) << now[1];
}

// What a growth turns by is said of it.
TEST_F(TipsJudged, AreSpokenOfBecauseOfABendAtFirstOnly) {
    MeshJudge judge, other;
    EXPECT_TRUE(look(judge, 2100.0).empty());
    input.cracks[0].points = {{0.0, 10.3}, {7.5, 10.3}, {8.3, 11.4}};
    EXPECT_TRUE(look(judge, 2100.0).empty());
    const Said now = look(other, 2100.0);
    ASSERT_EQ(now.size(), 1U);
    EXPECT_NE(now[0].find("its crack bends"), std::string::npos) << now[0];
}

// An element that the case wants split three times: larger refinement is no advice.
TEST_F(TipsJudged, StandOnElementsThatCannotBeSplit) {
    input.fine.refine = 8;
    MeshJudge judge;
    const Said first = look(judge, 2100.0);
    EXPECT_TRUE(first.empty()) << first[0];
    const Said now = look(judge, 900.0);
    ASSERT_EQ(now.size(), 2U);
    EXPECT_NE(now[0].find("tip 0 has come to elements of 1 mm, 8 times as large"), std::string::npos) << now[0];
    EXPECT_NE(now[1].find("spans 1.4 elements of 1 mm"), std::string::npos) << now[1];
    EXPECT_EQ(now[1].find("fine.refine"), std::string::npos) << now[1];
}

}  // namespace
}  // namespace stria::test
