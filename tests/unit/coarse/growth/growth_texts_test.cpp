// What is said of growth.
#include "coarse/growth/growth_texts.hpp"

#include <gtest/gtest.h>

namespace stria::coarse {
namespace {

TEST(GrowthTexts, SayWhatOfATipIsNotToldBehindASharpTurn) {
    EXPECT_EQ(turns_sharply(1, 0.15, 0.1),
              "warning: tip 1 turns sharply and grows by 0.15 mm, less than 2 elements of 0.1 mm: its K is not "
              "resolved until it is as far behind the bend, and its J is not told until it is 4 elements behind it; "
              "steps of 0.4 mm or more, or elements of 0.0375 mm or less, tell both");
    EXPECT_EQ(turns_sharply(0, 0.3, 0.1),
              "warning: tip 0 turns sharply and grows by 0.3 mm, 3 elements of 0.1 mm: its J is not told until it is "
              "4 elements behind the bend; steps of 0.4 mm or more, or elements of 0.075 mm or less, tell both");
    EXPECT_FALSE(turns_sharply(0, 0.41, 0.1));
}

}  // namespace
}  // namespace stria::coarse
