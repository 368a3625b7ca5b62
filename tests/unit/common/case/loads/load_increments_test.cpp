// Increments that follow from how the loads of a case move.
#include "common/case/loads/load_increments.hpp"

#include <gtest/gtest.h>

#include "tests/support/load_cases.hpp"

namespace stria {
namespace {

TEST(LoadIncrements, ArePartsOfTheHalfWidthOfWhatTravels) {
    std::vector<BoundarySection> boundaries(1);
    EXPECT_EQ(increments_of_travel(boundaries, 0.25), 0);
    boundaries.push_back(test::under_wheel("top", {.p0 = 1.0, .half_width = 1.0, .from = 8.0, .to = -8.0}));
    EXPECT_EQ(increments_of_travel(boundaries, 0.25), 64);
    EXPECT_EQ(increments_of_travel(boundaries, 0.5), 32);
    EXPECT_EQ(increments_of_travel(boundaries, 0.51), 32);
    boundaries.push_back(test::under_wheel("top", {.p0 = 1.0, .half_width = 0.5, .from = 0.0, .to = 10.1}));
    EXPECT_EQ(increments_of_travel(boundaries, 0.25), 82) << "of the one that wants most";
    boundaries.back().travelling->half_width = 1e-300;
    EXPECT_EQ(increments_of_travel(boundaries, 0.25), 1000);
}

TEST(LoadIncrements, AreChosenWhereNoneAreGiven) {
    Case input;
    const auto chosen = [&] {
        Case whole = input;
        choose_increments(whole);
        return whole.load.steps;
    };
    EXPECT_TRUE(chosen().is_auto());
    input.load_cases = {test::dead_load("dead", 3.0), test::lagging_load("beside", 1.0, 180.0)};
    EXPECT_TRUE(chosen().is_auto()) << "one line";
    input.load_cases.push_back(test::lagging_load("shear", 1.0, 90.0));
    EXPECT_EQ(chosen(), 24);
    input.boundaries = {test::under_wheel("top", {.p0 = 1.0, .half_width = 1.0, .from = -8.0, .to = 8.0})};
    EXPECT_EQ(chosen(), 64);
    input.load_cases.clear();
    EXPECT_EQ(chosen(), 64);
    input.boundaries[0].travelling->half_width = 16.0;
    EXPECT_EQ(chosen(), 12);
    input.load.steps = 8;
    EXPECT_EQ(chosen(), 8);
}

}  // namespace
}  // namespace stria
