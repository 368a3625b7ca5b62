// Where contact comes and goes between two states, found by trying.
#include "coarse/closure.hpp"

#include <gtest/gtest.h>

namespace stria::coarse {
namespace {

Case loaded() {
    Case input;
    input.load.blocks = {{.cycles = 1, .max = 100.0, .min = 0.0}};
    input.material.yield_stress = 300.0;
    return input;
}

NewtonReport with_reach(double reach) {
    NewtonReport report{.converged = true, .iterations = {{}}, .failure = {}};
    report.iterations.back().residual.contact_reach = {reach};
    return report;
}

TEST(ClosureMeter, CountsOnlyContactBeyondItsDistance) {
    Case input = loaded();
    input.closure.distance = 0.2;
    const ClosureMeter meter(input, {500.0});
    EXPECT_EQ(meter.closed(with_reach(0.3)), std::vector<char>{1});
    EXPECT_EQ(meter.closed(with_reach(0.1)), std::vector<char>{0});
    EXPECT_EQ(meter.closed(with_reach(-1.0)), std::vector<char>{0});
    EXPECT_NEAR(ClosureMeter(loaded(), {500.0}).distances()[0], 0.1 * 3.14159265 / 16.0 * 25.0 / 9.0, 1e-6);
}

TEST(ClosureMeter, FindsTheLoadToAFifthOfAPerCentOfTheLargest) {
    Case input = loaded();
    input.closure.distance = 0.2;
    const ClosureMeter meter(input, {500.0});
    int trials = 0;
    const auto solve = [&](double target) {
        ++trials;
        return ClosureMeter::Trial{with_reach(target < 37.3 ? 1.0 : -1.0), target};
    };
    const auto opening = meter.locate({1}, {0}, 30.0, 40.0, solve);
    ASSERT_EQ(opening.size(), 1U);
    EXPECT_FALSE(opening[0].closes);
    EXPECT_NEAR(opening[0].load_factor, 37.3, 0.2);
    EXPECT_LE(trials, 7);
    const auto closing = meter.locate({0}, {1}, 40.0, 30.0, solve);
    ASSERT_EQ(closing.size(), 1U);
    EXPECT_TRUE(closing[0].closes);
    EXPECT_NEAR(closing[0].load_factor, 37.3, 0.2);
    EXPECT_TRUE(meter.locate({1}, {1}, 30.0, 40.0, solve).empty());
}

TEST(ClosureMeter, StopsWhereATrialFails) {
    const ClosureMeter meter(loaded(), {500.0});
    const auto fails = [](double) { return ClosureMeter::Trial{}; };
    EXPECT_TRUE(meter.locate({1}, {0}, 30.0, 40.0, fails).empty());
}

}  // namespace
}  // namespace stria::coarse
