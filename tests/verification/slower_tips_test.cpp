// Two cracks of unlike length: how far the slower one has come when the faster one is as long as asked.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

/// Two edge cracks, from opposite sides and far from each other.
Case unlike_cracks() {
    Case input = specimen("plate", 120.0, {{0.0, 30.3}, {10.3, 30.3}});
    input.mesh.width = 40.0;
    input.mesh.size = 2.0;
    input.cracks.emplace_back().points = {{40.0, 90.3}, {33.3, 90.3}};
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load.blocks = {{.cycles = 60, .max = 60.0, .min = 0.0}};
    input.load.steps = 2;
    return input;
}

/// Of the shorter one, mm.
double shorter_crack_after(double increment, GrowthSection growth, int every = 1) {
    Case input = unlike_cracks();
    growth.increment = increment;
    growth.until = 20.3;
    growth.every = every;
    input.growth = growth;
    input.closure.distance = 0.5;
    const RunHistory run = run_direct(input);
    EXPECT_NEAR(run.increments.back().tips.at(0).a, 20.3, 1e-9);
    return run.increments.back().tips.at(1).a;
}

// By rates of the middle of an increment: 7.4950, 7.3985, 7.3701, 7.3600 and 7.3597 mm with 2, 1, 0.5, 0.1 and 0.05 mm.
// By those of its beginning, on elements half as large, 1 and 0.25 mm gave 7.4902 and 7.3906.
TEST(SlowerTips, GoAsFarToSecondOrderOfTheIncrement) {
    constexpr double limit = 7.3595;  // of 0.1 and 0.05 mm, extrapolated
    const GrowthSection paris{.law = GrowthLaw::Paris, .C = 1e-13, .m = 4.0};
    const double of_2 = shorter_crack_after(2.0, paris) - limit, of_1 = shorter_crack_after(1.0, paris) - limit,
                 of_half = shorter_crack_after(0.5, paris) - limit;
    EXPECT_LT(of_1, 0.05);
    EXPECT_NEAR(shorter_crack_after(1.0, paris, 2) - limit, of_1, 1e-9) << "an elastic body does not see other cycles";
    EXPECT_GT(std::log2(of_2 / of_1), 1.7);
    EXPECT_GT(std::log2(of_1 / of_half), 1.7);
}

// Of openings nobody takes a trend: by the rates at the beginning of each growth alone 2, 1 and 0.5 mm are 0.463, 0.229
// and 0.115 mm too far.
TEST(SlowerTips, GoAsFarToSecondOrderByTheirOpenings) {
    constexpr double limit = 9.3702;  // of 0.25 and 0.125 mm, extrapolated
    const GrowthSection by_openings{.law = GrowthLaw::Ctod, .C = 1.0, .m = 2.0};
    const double of_2 = shorter_crack_after(2.0, by_openings) - limit,
                 of_1 = shorter_crack_after(1.0, by_openings) - limit,
                 of_half = shorter_crack_after(0.5, by_openings) - limit;
    EXPECT_LT(of_1, 0.05);
    EXPECT_GT(std::log2(of_2 / of_1), 1.7);
    EXPECT_GT(std::log2(of_1 / of_half), 1.7);
}

}  // namespace
}  // namespace stria::test
