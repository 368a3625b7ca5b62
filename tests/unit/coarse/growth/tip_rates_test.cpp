// What each tip advances of what the fastest one does.
#include "coarse/growth/tip_rates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace stria::coarse {
namespace {

constexpr double known = std::numeric_limits<double>::quiet_NaN();  // K of a tip that has not just turned

/// Of two tips: one grew twice as fast over the last growth as before it, the other as fast as before.
TipRates rates_of(const GrowthSection& growth, std::vector<LoadBlock> blocks, std::vector<double> at_turn = {}) {
    Case input;
    input.growth = growth;
    input.load.blocks = std::move(blocks);
    return TipRates(
        input,
        {.period = {.sum = {2.0, 1.0}, .cycles = 1, .grown = {0.1, 0.1}, .before = {1.0, 1.0}, .at_growth = {1.0, 1.0}},
         .life = {},
         .at_turn = std::move(at_turn)});
}

constexpr double at_begin = 0.5, in_the_middle = 0.5 / std::numbers::sqrt2;

TEST(TipRates, ShareOutAnIncrementByThoseOfItsMiddle) {
    const GrowthSection paris{.law = GrowthLaw::Paris, .increment = 0.1, .C = 1e-12, .m = 3.0};
    const std::vector<LoadBlock> alike{{.cycles = 4, .max = 1.0, .min = 0.0}};
    const TipRates rates = rates_of(paris, alike);
    EXPECT_EQ(rates.present(), (std::vector<double>{2.0, 1.0}));
    EXPECT_EQ(rates.shares(2)[0], 1.0);
    EXPECT_NEAR(rates.shares(2)[1], in_the_middle, 1e-15);
    std::vector<Tip> tips(2);
    for (const double half : rates.lengthening(tips)) EXPECT_NEAR(half, 0.5 * (1.0 + in_the_middle), 1e-15);
    tips[1].crack = 1;
    EXPECT_NEAR(rates.lengthening(tips)[1], in_the_middle, 1e-15);
}

TEST(TipRates, ShareItOutByThoseOfItsBeginningWhereTheyTellNoTrend) {
    GrowthSection growth{.law = GrowthLaw::Paris, .increment = 0.1, .C = 1e-12, .m = 3.0};
    const std::vector<LoadBlock> alike{{.cycles = 4, .max = 1.0, .min = 0.0}};
    EXPECT_EQ(rates_of(growth, alike, {known, 0.2}).shares(2)[1], at_begin) << "one has just turned";
    EXPECT_NEAR(rates_of(growth, alike, {known, known}).shares(2)[1], in_the_middle, 1e-15);
    const std::vector<LoadBlock> unlike{{.cycles = 4, .max = 1.0, .min = 0.0}, {.cycles = 4, .max = 2.0, .min = 0.0}};
    EXPECT_EQ(rates_of(growth, unlike).shares(2)[1], at_begin) << "of cycles that differ";
    growth.every = 4;
    EXPECT_EQ(rates_of(growth, unlike).shares(2)[1], at_begin) << "or their means";
    growth.every = 1;
    growth.driving = GrowthDriving::EffectiveRange;
    EXPECT_EQ(rates_of(growth, alike).shares(2)[1], at_begin) << "openings swing";
}

// Ranges that are not told a trend of: the slower tip has advanced by 0.01 mm too much over 0.1 mm of the faster one.
TEST(TipRates, MakeUpForWhatTheLastGrowthLacked) {
    Case input;
    input.growth = GrowthSection{.law = GrowthLaw::Ctod, .increment = 0.1, .C = 1.0, .m = 1.0};
    input.load.blocks = {{.cycles = 4, .max = 1.0, .min = 0.0}};
    TipRatesMemory memory{
        .period = {.sum = {2.0, 1.0}, .cycles = 1, .grown = {}, .before = {}}, .life = {}, .at_turn = {}};
    memory.owed = {0.0, -0.01};
    memory.last = 0.1;
    const auto share = [&] { return TipRates(input, memory).shares(2)[1]; };
    EXPECT_NEAR(share(), 0.5 - 0.1, 1e-15);
    memory.owed[1] = -0.2;
    EXPECT_EQ(share(), 0.0) << "it does not go back";
    memory.owed[1] = 0.2;
    EXPECT_EQ(share(), 1.0) << "the fastest one goes farthest";
    memory.owed = {0.05, 0.0};
    EXPECT_EQ(TipRates(input, memory).shares(2)[0], 1.0);
    memory.at_turn = {known, 0.2};
    memory.owed[1] = -0.01;
    EXPECT_EQ(share(), at_begin) << "one has just turned";
}

TEST(TipRates, OfATipThatHasJustTurnedAreNoLessThanBehindItsTurn) {
    const GrowthSection growth{.law = GrowthLaw::Paris, .increment = 0.1, .C = 1e-12, .m = 3.0};
    TipRates rates = rates_of(growth, {{.cycles = 4, .max = 1.0, .min = 0.0}});
    rates.leap({{.tip = 1, .leap = 2.0}});
    EXPECT_NEAR(rates.present()[1], 8.0, 1e-12);
    EXPECT_EQ(rates.present()[0], 2.0);
}

TEST(TipRates, StartWhereATurnDrivesATipThatStands) {
    const GrowthSection growth{.law = GrowthLaw::Paris, .increment = 0.1, .C = 1e-12, .m = 3.0};
    TipRates rates = rates_of(growth, {{.cycles = 4, .max = 1.0, .min = 0.0}});
    rates.start(1, 5.0);
    EXPECT_EQ(rates.present(), (std::vector<double>{2.0, 5.0}));
    EXPECT_EQ(rates.memory().life.rate_at_turn, 5.0) << "it is the fastest now";
    TipRates slower = rates_of(growth, {{.cycles = 4, .max = 1.0, .min = 0.0}});
    slower.start(1, 1.5);
    EXPECT_NE(slower.memory().life.rate_at_turn, 1.5);
}

}  // namespace
}  // namespace stria::coarse
