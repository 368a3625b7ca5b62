// Opening loads that go to and fro from growth to growth are said once, and no trend is.
#include "coarse/cycle/opening_swing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coarse/zone/refined_scene.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::coarse {
namespace {

using Places = std::vector<std::size_t>;

TEST(PlacesOfTurns, AreTheExtremesBetweenLegsThatAreLongEnough) {
    EXPECT_EQ(places_of_turns({0.30, 0.31, 0.36, 0.33, 0.30, 0.31, 0.35}, 0.04), (Places{0, 2, 4, 6}));
    EXPECT_EQ(places_of_turns({0.36, 0.30, 0.36, 0.30}, 0.04), (Places{0, 1, 2, 3}));
    EXPECT_EQ(places_of_turns({0.30, 0.28, 0.40}, 0.04), (Places{1, 2})) << "it begins where it is lowest";
}

TEST(PlacesOfTurns, TellNothingOfWhatGoesLessFar) {
    EXPECT_TRUE(places_of_turns({}, 0.04).empty());
    EXPECT_TRUE(places_of_turns({0.30, 0.33, 0.30, 0.33, 0.30}, 0.04).empty());
    EXPECT_EQ(places_of_turns({0.10, 0.15, 0.13, 0.20, 0.17, 0.25}, 0.04), (Places{0, 5})) << "a trend";
}

/// A plate whose crack grows under 30 cycles, in blocks.
class SwingOfOpenings : public testing::Test {
protected:
    SwingOfOpenings() : SwingOfOpenings(std::vector<LoadBlock>{{.cycles = 30, .max = 10.0, .min = 0.0}}) {}
    explicit SwingOfOpenings(const std::vector<LoadBlock>& blocks) {
        input = test::sent_case({"mesh.width=24.0", "mesh.size=2.0", "mesh.grading=[]", "fine.refine=1"});
        input.growth = GrowthSection{.increment = 0.5};
        input.load.blocks = blocks;
    }

    /// What is said of cycles with such K_op / K_max, one after the other.
    std::vector<std::string> said_of(const std::vector<double>& ratios) {
        const Scene scene = refined_scene(input);
        OpeningSwing swing(input);
        std::vector<std::string> all;
        for (int cycle = 1; cycle <= std::ssize(ratios); ++cycle) {
            std::vector<CycleResult> cycles(1);
            cycles.front().K_max = 400.0;
            cycles.front().opening.K_op = 400.0 * ratios[static_cast<std::size_t>(cycle - 1)];
            for (const std::string& sentence : swing.add(cycle, cycles, scene)) all.push_back(sentence);
            swing = OpeningSwing(input, swing.memory());  // as a run does that is resumed there
        }
        return all;
    }

    Case input;
};

TEST_F(SwingOfOpenings, IsSaidOnceWithItsNumbersAndTheElementsThatWouldDo) {
    const std::vector<std::string> said = said_of({0.29, 0.30, 0.35, 0.28, 0.33, 0.26, 0.33, 0.27, 0.33});
    ASSERT_EQ(said.size(), 1U);
    EXPECT_NE(said.front().find("by 0.07: 0.29 in cycle 1, 0.35 in cycle 3, 0.28 in cycle 4, 0.33 in cycle 5"),
              std::string::npos)
        << said.front();
    EXPECT_NE(said.front().find("fine.refine = 2 "), std::string::npos) << said.front();
}

TEST_F(SwingOfOpenings, IsSaidOnceMoreWhereItTakesFinerElements) {
    const std::vector<std::string> said = said_of({0.30, 0.35, 0.30, 0.35, 0.24, 0.34, 0.22, 0.33});
    ASSERT_EQ(said.size(), 2U);
    EXPECT_NE(said.front().find("by 0.05"), std::string::npos) << said.front();
    EXPECT_NE(said.front().find("fine.refine = 2 "), std::string::npos) << said.front();
    EXPECT_NE(said.back().find("by 0.11"), std::string::npos) << said.back();
    EXPECT_NE(said.back().find("fine.refine = 4 "), std::string::npos) << said.back();
}

TEST_F(SwingOfOpenings, IsNoTrendAndNoTrendThatTurns) {
    EXPECT_TRUE(said_of({0.0, 0.10, 0.16, 0.22, 0.26, 0.30, 0.28, 0.25, 0.22, 0.20}).empty());
    EXPECT_TRUE(said_of({0.30, 0.32, 0.30, 0.33, 0.30, 0.32, 0.30}).empty()) << "by less than 0.04";
    EXPECT_TRUE(said_of({0.30, 0.31, 0.33, 0.36, 0.35, 0.33, 0.31, 0.30, 0.32, 0.34, 0.36}).empty()) << "slowly";
}

TEST_F(SwingOfOpenings, IsThatOfFacesThatMayTouch) {
    input.cracks.front().contact.reset();
    EXPECT_TRUE(said_of({0.30, 0.36, 0.30, 0.36, 0.30}).empty());
}

TEST_F(SwingOfOpenings, PassesOverCyclesThatTellNoOpeningLoad) {
    EXPECT_EQ(said_of({0.30, 0.36, NAN, 0.30, NAN, 0.36}).size(), 1U);
}

// The cycle behind a growth is another one than the last before the next.
TEST_F(SwingOfOpenings, LooksAtTheLastCycleBeforeEachGrowth) {
    input.growth->every = 2;
    EXPECT_TRUE(said_of({0.30, 0.36, 0.30, 0.36, 0.30, 0.36, 0.30, 0.36}).empty());
    EXPECT_EQ(said_of({0.0, 0.30, 0.0, 0.36, 0.0, 0.30, 0.0, 0.36}).size(), 1U);
}

// Behind an overload K_op falls, rises and falls again.
TEST_F(SwingOfOpenings, IsOfOneLoad) {
    input.load.blocks = {{.cycles = 3, .max = 10.0, .min = 0.0},
                         {.cycles = 1, .max = 15.0, .min = 0.0},
                         {.cycles = 26, .max = 10.0, .min = 0.0}};
    EXPECT_TRUE(said_of({0.30, 0.30, 0.20, 0.20, 0.40, 0.36, 0.33, 0.30}).empty());
    EXPECT_EQ(said_of({0.30, 0.30, 0.20, 0.20, 0.40, 0.30, 0.36, 0.30}).size(), 1U);
    input.load_cases.emplace_back();
    input.load_cases.front().blocks = {{.cycles = 15, .at_max = 1.0, .at_min = 0.0},
                                       {.cycles = 15, .at_max = 2.0, .at_min = 0.0}};
    EXPECT_TRUE(said_of({0.30, 0.36, 0.30, 0.36, 0.30, 0.36}).empty()) << "nobody tells what load it is";
}

}  // namespace
}  // namespace stria::coarse
