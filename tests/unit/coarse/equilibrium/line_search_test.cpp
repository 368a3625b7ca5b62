// The root of the residual's work along a correction that leads nowhere.
#include "coarse/equilibrium/line_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace stria::coarse {
namespace {

Residual state(double interior, double along, double before = 1.0) {
    return {.interior = interior, .along = along, .along_before = before};
}

/// Six corrections that lead nowhere.
LineSearch stuck() {
    LineSearch search;
    for (int k = 0; k < 6; ++k) EXPECT_EQ(search.further(state(1.0, -2.0)), 0.0);
    return search;
}

TEST(LineSearch, LeavesCorrectionsThatLeadSomewhere) {
    LineSearch search;
    for (const double residual : {8.0, 9.0, 4.0, 3.0, 1.0, 0.5, 0.1, 0.01, 1e-5})
        EXPECT_EQ(search.further(state(residual, -2.0)), 0.0);
}

TEST(LineSearch, GivesBackWhatLeadsTooFar) {
    LineSearch search = stuck();
    EXPECT_NEAR(search.further(state(1.0, -3.0)), -0.75, 1e-15);  // from 1 at the start to -3: a quarter is enough
    EXPECT_EQ(search.further(state(1.0, 0.0)), 0.0);
    EXPECT_EQ(search.further(state(1.0, 0.4)), 0.0);  // another correction, that ends near the root
}

TEST(LineSearch, LeavesACorrectionThatDoesNotReachTheRoot) {
    LineSearch search = stuck();
    EXPECT_EQ(search.further(state(1.0, 0.9)), 0.0);
}

TEST(LineSearch, KnowsNothingWithoutWork) {
    LineSearch search = stuck();
    EXPECT_EQ(search.further(state(1.0, 0.0, 0.0)), 0.0);
    EXPECT_EQ(search.further(state(1.0, -3.0, -1.0)), 0.0);  // no potential falls along it
}

// Flat, steep and flat again: where an element flows forwards, is elastic, flows backwards.
TEST(LineSearch, FindsTheRootBetweenTwoFlatBranches) {
    const std::function<double(double)> work = [](double part) {
        constexpr double root = 0.07;
        return std::clamp(-200.0 * (part - root), -20.0, 1.0);
    };
    LineSearch search = stuck();
    double part = 1.0;
    for (int k = 0; k < 5; ++k) part += search.further(state(1.0, work(part)));
    EXPECT_LE(std::abs(work(part)), 0.5);
    EXPECT_NEAR(part, 0.07, 0.003);
}

TEST(LineSearch, EndsAfterFiveParts) {
    LineSearch search = stuck();
    int parts = 0;
    while (search.further(state(1.0, -3.0)) != 0.0) ++parts;
    EXPECT_EQ(parts, 5);
}

}  // namespace
}  // namespace stria::coarse
