// What drives a tip behind a turn, by the K of an infinitesimal kink: cos(a/2) (K_I cos^2(a/2) - 3/2 K_II sin a).
#include "coarse/growth/rate_behind_turn.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
    modes.cycles[5].K_II = std::nan("");
    EXPECT_TRUE(std::isnan(rate()));
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

TEST_F(RateBehindTurn, OfOpeningLoadsIsKnownOfFacesThatCannotTouch) {
    const double of_range = rate();
    growth.driving = GrowthDriving::EffectiveRange;
    EXPECT_EQ(rate(), of_range);
    crack.contact.emplace();
    EXPECT_TRUE(std::isnan(rate()));
}

}  // namespace
}  // namespace stria::coarse
