// What drives a tip behind a turn, by the K of an infinitesimal kink: cos(a/2) (K_I cos^2(a/2) - 3/2 K_II sin a).
#include "coarse/growth/rate_behind_turn.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace stria::coarse {
namespace {

constexpr double angle = -1.1;  // radians: K_II above zero opens it

double kinked(const ModesOfTip& modes) {
    const double c = std::cos(angle / 2.0);
    return c * (modes.K_I * c * c - 1.5 * modes.K_II * std::sin(angle));
}

/// Of two tips, of which the second one is asked; two cycles.
class RateBehindTurn : public testing::Test {
protected:
    RateBehindTurn() {
        growth.law = GrowthLaw::Paris;
        growth.C = 1e-11;
        growth.m = 3.0;
    }
    [[nodiscard]] double rate() const { return rate_behind_turn(growth, crack, modes, 1, angle); }
    /// By the range of K, of which no part is below zero.
    [[nodiscard]] double of_cycle(std::size_t c) const {
        const double range = kinked(modes.cycles[4 * c + 1]) - kinked(modes.cycles[4 * c + 3]);
        return growth.C * std::pow(range, growth.m);
    }

    GrowthSection growth;
    CrackSection crack;
    const ModesOfTip other{1e3, 1e3};
    TurningModes modes{.minimum = {other, {0.0, 10.0}},
                       .cycles = {other, {5.0, 300.0}, other, {1.0, 30.0}, other, {0.0, 500.0}, other, {2.0, 50.0}}};
};

TEST_F(RateBehindTurn, IsTheMeanOfTheCyclesSinceTheTipGrew) {
    EXPECT_NEAR(rate(), 0.5 * (of_cycle(0) + of_cycle(1)), 1e-12 * rate());
    EXPECT_GT(of_cycle(1), 4.0 * of_cycle(0));
}

TEST_F(RateBehindTurn, IsNotKnownBeforeACycleHasEnded) {
    modes.cycles.clear();
    EXPECT_TRUE(std::isnan(rate()));
}

TEST_F(RateBehindTurn, IsNotKnownWhereAModeIsNot) {
    for (const std::size_t extreme : {1U, 3U, 5U, 7U}) {
        const ModesOfTip known = modes.cycles[extreme];
        modes.cycles[extreme].K_II = std::nan("");
        EXPECT_TRUE(std::isnan(rate())) << extreme;
        modes.cycles[extreme] = known;
    }
}

TEST_F(RateBehindTurn, IsNotKnownWhereRoughFacesArePressedAsTheTipIsDriven) {
    crack.contact.emplace();
    modes.cycles[1].K_I = -4.0;
    EXPECT_FALSE(std::isnan(rate())) << "smooth faces";
    crack.contact->friction = 0.3;
    EXPECT_TRUE(std::isnan(rate()));
    modes.cycles[1].K_I = -2.0;
    EXPECT_FALSE(std::isnan(rate())) << "next to nothing beside K_II";
}

// The other end of a cycle drives a tip that slides back.
TEST_F(RateBehindTurn, AsksForThePressureAtTheExtremeThatDrives) {
    crack.contact.emplace();
    crack.contact->friction = 0.3;
    modes.cycles[1] = {-4.0, 30.0};
    modes.cycles[3] = {5.0, 300.0};
    EXPECT_FALSE(std::isnan(rate()));
    std::swap(modes.cycles[1].K_I, modes.cycles[3].K_I);
    EXPECT_TRUE(std::isnan(rate()));
}

TEST_F(RateBehindTurn, IsOfFacesThatDoNotPassThroughEachOther) {
    for (const std::size_t extreme : {1U, 3U}) {
        crack.contact.reset();
        const double known = modes.cycles[extreme].K_I;
        modes.cycles[extreme].K_I = 0.0;
        const double shut = rate();
        modes.cycles[extreme].K_I = -20.0;
        EXPECT_NE(rate(), shut) << "nothing holds faces without contact apart";
        crack.contact.emplace();
        EXPECT_EQ(rate(), shut);
        modes.cycles[extreme].K_I = known;
    }
}

TEST_F(RateBehindTurn, OfOpeningLoadsIsKnownOfFacesThatCannotTouch) {
    const double of_range = rate();
    growth.driving = GrowthDriving::EffectiveRange;
    growth.walker = 0.5;  // a part of laws of dK alone
    EXPECT_EQ(rate(), of_range);
    crack.contact.emplace();
    EXPECT_TRUE(std::isnan(rate()));
}

TEST_F(RateBehindTurn, OfOpeningsIsNotKnown) {
    growth.law = GrowthLaw::Ctod;
    EXPECT_TRUE(std::isnan(rate()));
}

}  // namespace
}  // namespace stria::coarse
