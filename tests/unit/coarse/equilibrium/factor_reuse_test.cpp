// A factor is kept where one of its own would not end the search sooner.
#include "coarse/equilibrium/factor_reuse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace stria::coarse {
namespace {

constexpr double tolerance = 2e-5;

Residual state(double residual, bool kept) { return {.interior = residual, .scale = 1.0, .keeps_factor = kept}; }

struct Search {
    int iterates = 0, factored = 0;
};

using Function = std::function<double(double)>;

/// The root of `residual` from 0, with the slope that `tangent` says wherever a factor is made.
Search search(const Function& residual, const Function& tangent, bool reuses) {
    FactorReuse reuse(tolerance);
    Search done;
    double x = 0.0, slope = 0.0, below = 0.0;
    while (done.iterates < 30) {
        const double left = residual(x);
        const bool kept = reuses && done.iterates > 0 && std::abs(left) <= below;
        ++done.iterates;
        if (!kept) {
            slope = tangent(x);
            ++done.factored;
        }
        reuse.add(state(std::abs(left), kept));
        below = reuse.below();
        if (std::abs(left) <= tolerance) break;
        x -= left / slope;
    }
    return done;
}

/// x + c x^2 = a.
Function parabola(double c, double a) {
    return [=](double x) { return x + c * x * x - a; };
}
Function slope_of_parabola(double c) {
    return [=](double x) { return 1.0 + 2.0 * c * x; };
}

TEST(FactorReuse, ServesOnceMoreWhereTheChordReachesTheTolerance) {
    for (const double c : {0.005, 0.02, 0.1}) {
        const Search all = search(parabola(c, 0.1), slope_of_parabola(c), false);
        const Search reused = search(parabola(c, 0.1), slope_of_parabola(c), true);
        EXPECT_EQ(reused.iterates, all.iterates) << c;
        EXPECT_LT(reused.factored, all.factored) << c;
    }
}

// From r0 on to r1 one more correction by the chord leaves 2 r1^2 / r0.
TEST(FactorReuse, ServesWhereTheChordLeavesHalfOfTheTolerance) {
    for (const double residual : {0.01, 0.1, 3.0}) {
        FactorReuse reuse(tolerance);
        reuse.add(state(residual, false));
        EXPECT_NEAR(2.0 * reuse.below() * reuse.below() / residual, 0.5 * tolerance, 1e-9 * tolerance);
    }
}

TEST(FactorReuse, IsNotPutOffWhereTheChordWouldFallShort) {
    // After one correction .0083 is left of .1: the chord would leave 1e-3.
    const Search all = search(parabola(1.0, 0.1), slope_of_parabola(1.0), false);
    const Search reused = search(parabola(1.0, 0.1), slope_of_parabola(1.0), true);
    EXPECT_EQ(reused.iterates, all.iterates);
    FactorReuse reuse(tolerance);
    reuse.add(state(0.1, false));
    EXPECT_LT(reuse.below(), 0.0083);
}

TEST(FactorReuse, ServesOnWhereTangentsAreNotWhatResidualsFallBy) {
    // A tangent that is a quarter too large leaves a fifth each time, whoever makes it anew.
    const auto tangent = [](double x) { return 1.25 * slope_of_parabola(0.01)(x); };
    const Search all = search(parabola(0.01, 1.0), tangent, false);
    const Search reused = search(parabola(0.01, 1.0), tangent, true);
    EXPECT_EQ(reused.iterates, all.iterates);
    EXPECT_EQ(reused.factored, 4);
    EXPECT_GT(all.factored, 7);
}

TEST(FactorReuse, GivesUpAFactorByWhichResidualsFallSlowly) {
    FactorReuse reuse(tolerance);
    for (const double residual : {0.5, 0.3, 0.2, 4e-3}) reuse.add(state(residual, false));
    EXPECT_NEAR(reuse.below(), 1.2e-3, 1e-15);
    reuse.add(state(1e-3, true));
    EXPECT_NEAR(reuse.below(), 3e-4, 1e-15);
}

TEST(FactorReuse, ServesToEndButNotWhereTheCorrectionIsStillLarge) {
    FactorReuse reuse(tolerance);
    reuse.add(state(1e-4, false));
    EXPECT_GE(reuse.below(), tolerance);
    reuse.add(state(1.5e-5, true));
    EXPECT_EQ(reuse.below(), 0.0);
}

}  // namespace
}  // namespace stria::coarse
