// What a run says of itself.
#include "coarse/analysis/run_texts.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria::coarse {
namespace {

/// Of loads that have done 100 N at most, and 10 N in the end.
WorkBalance open_by(double error, double dissipated) {
    WorkBalance work;
    work.external = 10.0;
    work.largest = 100.0;
    work.dissipated = dissipated;
    work.stored = work.external - dissipated - error;
    return work;
}

TEST(RunTexts, WarnOfAWorkBalanceThatIsOpenBesideTheLargestWork) {
    EXPECT_EQ(work_out_of_balance(open_by(0.9, 50.0)), "");
    EXPECT_EQ(work_out_of_balance(open_by(-0.9, 50.0)), "");
    EXPECT_NE(work_out_of_balance(open_by(1.1, 50.0)).find("1.1 % of the largest work"), std::string::npos);
    EXPECT_NE(work_out_of_balance(open_by(-1.1, 50.0)), "");
}

TEST(RunTexts, WarnOfAWorkBalanceThatIsOpenBesideWhatIsLost) {
    EXPECT_EQ(work_out_of_balance(open_by(0.5, 5.0)), "");
    EXPECT_NE(work_out_of_balance(open_by(0.5, 2.5)).find("20 % of what flow"), std::string::npos);
    EXPECT_EQ(work_out_of_balance(open_by(1e-5, 2e-5)), "") << "rounding";
    WorkBalance grown = open_by(0.5, 2.5);
    grown.released = 2.5, grown.stored -= 2.5;
    EXPECT_EQ(work_out_of_balance(grown), "");
}

TEST(RunTexts, SayNothingOfAWorkBalanceThatNobodyCouldClose) {
    EXPECT_EQ(work_out_of_balance({}), "");
    WorkBalance unseen = open_by(5.0, 5.0);
    unseen.released = std::nan("");
    EXPECT_EQ(work_out_of_balance(unseen), "");
}

// An initial stress has stored 20 N, and loads do next to nothing beside it.
TEST(RunTexts, SayNothingOfAWorkBalanceThatIsOpenByTheRoundingOfTheInitialStress) {
    WorkBalance strained;
    strained.external = strained.largest = 1e-13;
    strained.at_start = strained.stored = 20.0;
    EXPECT_GT(strained.share_of_largest(), 0.01) << "it is rounding that is tested";
    EXPECT_EQ(work_out_of_balance(strained), "");
}

TEST(RunTexts, NameNoShareOfWhatNothingHasDissipated) {
    WorkBalance elastic;
    elastic.external = elastic.largest = 1.0;
    elastic.stored = 0.9;
    const std::string text = work_out_of_balance(elastic);
    EXPECT_NE(text.find("10 % of the largest work of the loads: one"), std::string::npos) << text;
}

TEST(RunTexts, SayByHowMuchTheAccuracyIsMissed) {
    const std::string text = misses_accuracy(0.0042, 0.002);
    EXPECT_TRUE(text.starts_with("warning: load.accuracy = 0.002 may not be kept")) << text;
    EXPECT_NE(text.find("by 0.0042 of the range"), std::string::npos) << text;
}

}  // namespace
}  // namespace stria::coarse
