// Cycles of a growth whose rate is known at its ends, and behind sharp turns.
#include "coarse/growth/life_count.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "coarse/growth/growth_law.hpp"

namespace stria::coarse {
namespace {

using Rate = std::function<double(double)>;  // mm per cycle, at a distance that the tip has grown, mm

constexpr double resolved = 0.02;  // mm

/// Over a millimetre in equal increments; the crack turns where it begins.
double life(int increments, double before_turn, const Rate& seen, double behind_turn_at_start) {
    LifeCount count;
    double cycles = 0.0, before = before_turn;
    for (int k = 1; k <= increments; ++k) {
        const double size = 1.0 / increments, grown = k * size, now = seen(grown);
        cycles += count.passed({.grown = size, .behind_turn = behind_turn_at_start + grown, .resolved = resolved},
                               before, now);
        before = now;
    }
    EXPECT_EQ(count.memory().uncounted, 0.0);
    return cycles;
}

double life_behind_turn(int increments, double before_turn, const Rate& seen) {
    return life(increments, before_turn, seen, 0.0);
}

double straight_life(int increments, const Rate& seen) {
    return life(increments, seen(0.0), seen, std::numeric_limits<double>::infinity());
}

/// K = K_0 sqrt(a / a_0) of a_0 = 10 mm and m = 3: N = (2 / (C K_0^3)) a_0^1.5 (a_0^-.5 - a^-.5).
double paris(double grown) { return 1e-5 * std::pow(1.0 + grown / 10.0, 1.5); }
const double exact = 2.0 * 1e5 * 10.0 * (1.0 - std::sqrt(10.0 / 11.0));

TEST(LifeCount, IsOfSecondOrderWhereTheCrackIsStraight) {
    double last = 0.0;
    for (const int increments : {4, 8, 16, 32}) {
        const double error = std::abs(straight_life(increments, paris) / exact - 1.0);
        EXPECT_TRUE(last == 0.0 || std::abs(last / error - 4.0) < 0.05) << last / error;
        last = error;
    }
    EXPECT_LT(last, 3e-6);  // da^2 (f'(1) - f'(0)) / 12 of f = 1 / rate, relative to the life: 2.8e-6
}

// K leaps at the turn: with the rate before it in the sum, a tenth of that behind it, the error would be of first
// order.
TEST(LifeCount, IsOfSecondOrderBehindASharpTurn) {
    double last = 0.0;
    for (const int increments : {4, 8, 16, 32}) {
        const double error = std::abs(life_behind_turn(increments, 0.1 * paris(0.0), paris) / exact - 1.0);
        EXPECT_TRUE(last == 0.0 || std::abs(last / error - 4.0) < 0.3) << last / error;
        last = error;
    }
    EXPECT_LT(last, 1e-4);
}

// Nearer than two elements the rate is off by a factor of ten: none of it is in the sum.
TEST(LifeCount, DoesNotAskForARateThatIsNotResolved) {
    const auto seen = [](double grown) { return (grown < 0.99 * resolved ? 0.1 : 1.0) * paris(grown); };
    EXPECT_NEAR(life_behind_turn(400, 0.1 * paris(0.0), seen) / exact, 1.0, 1e-4);
    LifeCount count;
    EXPECT_EQ(count.passed({.grown = 0.005, .behind_turn = 0.005, .resolved = resolved}, 1e-5, 1e-6), 0.0);
    EXPECT_EQ(count.memory().uncounted, 0.005);
    LifeCount resumed(count.memory());
    EXPECT_NEAR(resumed.passed({.grown = 0.015, .behind_turn = 0.02, .resolved = resolved}, 1e-6, 1e-5), 2000.0, 1e-9);
    EXPECT_EQ(resumed.memory().uncounted, 0.0);
}

// Two elements are half of the life. With the rate at their end alone it would be 13 % too short.
TEST(LifeCount, BeginsWithTheRateOfACrackThatHasJustTurned) {
    const double wide = 1.0;
    LifeCount count, later;
    count.turn(paris(0.0));
    EXPECT_EQ(count.passed({.grown = 0.5, .behind_turn = 0.5, .resolved = wide}, 1e-9, 1e-9), 0.0);
    count.turn(7.0);  // again, before the first is counted
    LifeCount resumed(count.memory());
    for (LifeCount* one : {&count, &resumed}) {
        const double cycles = one->passed({.grown = 0.5, .behind_turn = 1.0, .resolved = wide}, 1e-9, paris(1.0));
        EXPECT_NEAR(cycles / exact, 1.0, 0.005);
        EXPECT_TRUE(std::isnan(one->memory().rate_at_turn));
    }
    later.turn(0.0);
    EXPECT_NEAR(later.passed({.grown = 1.0, .behind_turn = 1.0, .resolved = wide}, 1e-9, paris(1.0)), 1.0 / paris(1.0),
                1e-6);
}

// In the last cycle nothing is left to be counted later: K that is not resolved is too low.
TEST(LifeCount, CountsWhereTheRunEndsBehindATurn) {
    LifeCount count;
    count.turn(1e-5);
    EXPECT_EQ(count.passed({.grown = 0.005, .behind_turn = 0.005, .resolved = resolved}, 1e-6, 1e-7), 0.0);
    LifeCount still(count.memory());
    EXPECT_NEAR(count.passed({.grown = 0.01, .behind_turn = 0.015, .resolved = resolved, .ends = true}, 1e-6, 1e-7),
                1500.0, 1e-9);
    EXPECT_EQ(count.memory().uncounted, 0.0);
    EXPECT_NEAR(still.passed({.grown = 0.0, .behind_turn = 0.005, .resolved = resolved, .ends = true}, 1e-6, 2e-5),
                375.0, 1e-9);
}

TEST(LifeCount, CountsOfACrackThatTurnsAgainAndAgain) {
    LifeCount count;
    double cycles = 0.0;
    for (int k = 0; k < 40; ++k)
        cycles += count.passed({.grown = 0.005, .behind_turn = 0.005, .resolved = resolved}, 1e-5, 1e-5);
    EXPECT_NEAR(cycles, 20000.0, 1e-6);
}

TEST(LifeCount, NothingPassesWhereNothingGrows) {
    EXPECT_EQ(LifeCount().passed({.grown = 0.0, .behind_turn = 1.0, .resolved = resolved}, 0.0, 1e-5), 0.0);
}

// Straight on, and behind a turn, where growth is counted later.
TEST(LifeCount, SumsWhatItIsOffBy) {
    LifeCount count;
    count.passed({.grown = 0.1, .behind_turn = 1.0, .resolved = resolved}, 1e-5, 3e-5);
    count.turn(2e-5);
    count.passed({.grown = 0.01, .behind_turn = 0.01, .resolved = resolved}, 3e-5, 4e-5);
    EXPECT_EQ(count.memory().doubt, cycles_in_doubt({0.1, 1e-5, 3e-5}));
    count.passed({.grown = 0.02, .behind_turn = 0.03, .resolved = resolved}, 4e-5, 5e-5);
    EXPECT_DOUBLE_EQ(count.memory().doubt, cycles_in_doubt({0.1, 1e-5, 3e-5}) + cycles_in_doubt({0.03, 2e-5, 5e-5}));
}

// Both tips of a crack grow, one of them half as fast, and the last turn is 0.01 mm behind what is counted.
TEST(LifeCount, IsInDoubtByTheLengthOfTheCrack) {
    LifeCount count;
    count.passed({.grown = 4.0, .length = 7.0, .lengthening = 0.75, .behind_turn = 9.0}, 1e-5, 3e-5);
    EXPECT_DOUBLE_EQ(count.memory().doubt, cycles_in_doubt({4.0, 1e-5, 3e-5, 4.0, 3.0}));
    LifeCount later;
    later.turn(2e-5);
    later.passed({.grown = 0.01, .length = 1.01, .behind_turn = 0.01, .resolved = resolved}, 3e-5, 4e-5);
    later.passed({.grown = 0.02, .length = 1.03, .behind_turn = 0.03, .resolved = resolved}, 4e-5, 5e-5);
    EXPECT_DOUBLE_EQ(later.memory().doubt, cycles_in_doubt({0.03, 2e-5, 5e-5, 1.0, 0.03}));
}

/// What so many growths from `a` to `b` are said to be off by, over what they are, of a plate 20 mm wide.
double said_of(const std::function<double(double)>& K, double a, double b, int growths) {
    const auto rate = [&](double length) { return 1e-12 * std::pow(K(length), 3.0); };
    const auto trapezoids = [&](int parts, LifeCount* life) {
        double sum = 0.0;
        for (int k = 0; k < parts; ++k) {
            const double from = a + k * (b - a) / parts, to = a + (k + 1) * (b - a) / parts;
            sum += cycles_passed(to - from, rate(from), rate(to));
            if (life != nullptr)
                life->passed({.grown = to - from, .length = to, .behind_turn = INFINITY}, rate(from), rate(to));
        }
        return sum;
    };
    LifeCount life({}, 1.5);
    const double passed = trapezoids(growths, &life);
    return life.memory().doubt / (passed - trapezoids(4000, nullptr));
}

// As an edge crack parts a plate K rises by more than a power of the length, and by less between ends that are guided:
// by powers between two lengths it was 1.2 and 0.9 times as much.
TEST(LifeCount, ThreeLengthsTellWhatTwoDoNot) {
    const auto power = [](double a) { return std::sqrt(a); };
    const auto edge = [](double a) {
        return std::sqrt(a) * (1.12 + 2.5 * a * a / 400.0) / std::pow(1.0 - a / 20.0, 1.5);
    };
    const auto guided = [](double a) { return std::sqrt(a) * (1.12 - 0.3 * a / 20.0); };
    EXPECT_NEAR(said_of(power, 4.0, 12.0, 4), 1.0, 1e-3);
    EXPECT_NEAR(said_of(edge, 4.0, 12.0, 4), 1.0, 0.1);
    EXPECT_NEAR(said_of(edge, 8.0, 16.0, 8), 1.0, 0.05);
    EXPECT_NEAR(said_of(guided, 4.0, 12.0, 4), 1.0, 0.03);
    EXPECT_NEAR(said_of(guided, 1.0, 12.0, 3), 1.0, 0.05);
}

// One growth has no third length. A power through both ends said 1.3 to 1.8 times as much of an edge crack in a plate
// 20 mm wide (Brown and Srawley, ASTM STP 410), 1.4 times of a centre crack.
TEST(LifeCount, TwoLengthsTellItRoughly) {
    const auto power = [](double a) { return std::sqrt(a); };
    const auto edge = [](double a) {
        const double x = a / 20.0;
        return std::sqrt(a) * (1.12 + x * (-0.231 + x * (10.55 + x * (-21.7 + x * 30.4))));
    };
    const auto centre = [](double a) { return std::sqrt(a / std::cos(std::numbers::pi * a / 40.0)); };
    EXPECT_NEAR(said_of(power, 4.0, 12.0, 1), 1.0, 1e-3);
    EXPECT_NEAR(said_of(edge, 2.0, 6.0, 1), 1.0, 0.15);
    EXPECT_NEAR(said_of(edge, 4.0, 12.0, 1), 1.0, 0.15);
    EXPECT_NEAR(said_of(edge, 6.0, 12.0, 1), 1.0, 0.15);
    EXPECT_NEAR(said_of(centre, 4.0, 12.0, 1), 1.0, 0.15);
}

}  // namespace
}  // namespace stria::coarse
