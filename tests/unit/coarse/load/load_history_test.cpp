// Blocks, overloads and spectra as ways from one extreme to the next.
#include "coarse/load/load_history.hpp"

#include <gtest/gtest.h>

namespace stria::coarse {
namespace {

std::vector<double> ends(const LoadSection& load) {
    std::vector<double> found;
    for (const Leg& leg : legs(load)) found.push_back(leg.to);
    return found;
}

TEST(LoadHistory, AnOverloadIsOnePeak) {
    const LoadSection load{.blocks = {{2, 10.0, 1.0}, {1, 20.0, 1.0}, {1, 10.0, 1.0}}};
    EXPECT_EQ(ends(load), (std::vector<double>{10, 1, 10, 1, 20, 1, 10, 1, 10}));
    EXPECT_EQ(cycle_count(load), 4);
    EXPECT_EQ(largest_value(load), 20.0);
    int cycle = 0;
    for (const Leg& leg : legs(load)) {
        EXPECT_EQ(leg.at_minimum, leg.to == 1.0);
        EXPECT_TRUE(leg.reversal);
        EXPECT_EQ(leg.ends_cycle, leg.at_maximum && leg.cycle > 0);
        if (leg.at_minimum) {
            ++cycle;
        }
        EXPECT_EQ(leg.cycle, cycle);
    }
}

TEST(LoadHistory, RepeatsAndScales) {
    const LoadSection load{.blocks = {{1, 10.0, 0.0}, {1, 20.0, 0.0}}, .scale = 2.0, .repeat = 2};
    EXPECT_EQ(ends(load), (std::vector<double>{20, 0, 40, 0, 20, 0, 40, 0, 40}));
    EXPECT_EQ(cycle_count(load), 4);
    EXPECT_EQ(largest_value(load), 40.0);
}

// Ranges of 60, 40, 100 and 10 above zero, 9, 40, 1 and 400 times.
TEST(LoadHistory, KnowsTheMaximumUpToWhichHalfOfAGrowthIsMade) {
    const LoadSection load{
        .blocks = {{9, 30.0, -10.0}, {40, 20.0, 0.0}, {1, 50.0, 0.0}, {400, 45.0, 40.0}, {5, -1.0, -90.0}},
        .scale = 2.0};
    EXPECT_EQ(median_maximum(load, 0.0), 90.0);  // 400 of 450 cycles
    EXPECT_EQ(median_maximum(load, 1.0), 90.0);
    EXPECT_EQ(median_maximum(load, 3.0), 60.0);
    EXPECT_EQ(median_maximum(load, 20.0), 100.0);
    EXPECT_EQ(median_maximum({.blocks = {{3, -10.0, -20.0}}}, 3.0), 0.0);
}

TEST(LoadHistory, KnowsTheCyclesThatAreAhead) {
    const LoadSection load{.blocks = {{20, 100.0, 0.0}, {10, 50.0, 0.0}}};
    EXPECT_EQ(cycles_ahead(load, 0), load);
    EXPECT_EQ(cycles_ahead(load, 5).blocks, (std::vector<LoadBlock>{{15, 100.0, 0.0}, {10, 50.0, 0.0}}));
    EXPECT_EQ(cycles_ahead(load, 20).blocks, (std::vector<LoadBlock>{{10, 50.0, 0.0}}));
    EXPECT_EQ(cycles_ahead(load, 30).blocks, (std::vector<LoadBlock>{{3, 50.0, 0.0}})) << "a tenth at least";
    LoadSection sequence = load;
    sequence.repeat = 2;
    EXPECT_EQ(cycles_ahead(sequence, 20), sequence);
}

TEST(LoadHistory, TurnsOnlyWhereTheLoadDoes) {
    const std::vector<Leg> all = legs({.blocks = {{1, 20.0, 10.0}, {1, 5.0, 0.0}}});
    ASSERT_EQ(all.size(), 5U);  // 20, 10, 5, 0, 5: down all the way from 20 to 0
    EXPECT_TRUE(all[0].reversal && all[3].reversal && all[4].reversal);
    EXPECT_FALSE(all[1].reversal || all[2].reversal);
    EXPECT_TRUE(all[2].ends_cycle);
}

TEST(LoadHistory, FullCompressionNeedsNoRamp) {
    const std::vector<Leg> all = legs({.blocks = {{2, 0.0, -10.0}}});
    EXPECT_EQ(all.size(), 4U);
    EXPECT_EQ(all.front().cycle, 1);
    EXPECT_TRUE(all[1].ends_cycle);
}

// The next maximum is this minimum: the cycle has ended before the load turns up again.
TEST(LoadHistory, AWayOfNoLengthIsNone) {
    const std::vector<Leg> all = legs({.blocks = {{1, 20.0, 10.0}, {1, 10.0, 0.0}}});
    ASSERT_EQ(all.size(), 4U);
    EXPECT_TRUE(all[1].at_minimum && all[1].at_maximum && all[1].ends_cycle);
}

TEST(LoadHistory, ARampAloneIsOne) {  // tests of limit loads
    EXPECT_EQ(ends({.blocks = {{.cycles = 0, .max = 5.0, .min = 0.0}}}), std::vector<double>{5});
}

}  // namespace
}  // namespace stria::coarse
