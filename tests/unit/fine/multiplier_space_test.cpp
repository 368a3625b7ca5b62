// The trace of the contact multipliers: hats that add up to one, folded at tips, broken at kinks, none in a notch.
#include "fine/contact/multiplier_space.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

using fine::MultiplierSpace;

MultiplierSpace space_of(const std::vector<Point>& crack, double notch = 0.0, int columns = 12, int rows = 6) {
    return {plate_mesh(columns, rows, plate_case(crack)), {}, 0, notch};
}

double sum_at(const MultiplierSpace& space, double s) {
    double sum = 0.0;
    for (const auto& [multiplier, value] : space.at(s)) sum += multiplier >= 0 ? value : 0.0;
    return sum;
}

std::set<int> acting_between(const MultiplierSpace& space, double from, double to) {
    std::set<int> acting;
    for (int k = 1; k < 200; ++k) {
        for (const auto& [multiplier, value] : space.at(from + (to - from) * k / 200)) {
            if (multiplier >= 0 && value > 0.0) acting.insert(multiplier);
        }
    }
    return acting;
}

TEST(MultiplierSpace, HatsAddUpToOne) {
    for (const std::vector<Point>& crack :
         {std::vector<Point>{{0.0, 2.4}, {12.0, 2.4}}, {{0.0, 2.4}, {8.3, 3.7}}, {{2.2, 1.3}, {9.4, 4.6}},
          {{0.0, 1.3}, {4.5, 1.4}, {10.4, 4.6}}}) {
        const MultiplierSpace space = space_of(crack);
        double length = 0.0;
        for (std::size_t k = 1; k < crack.size(); ++k) length += (crack[k] - crack[k - 1]).norm();
        for (int k = 1; k < 100; ++k) EXPECT_NEAR(sum_at(space, length * k / 100), 1.0, 1e-14);
        EXPECT_EQ(sum_at(space, length + 0.1), 0.0);
    }
}

TEST(MultiplierSpace, IsCoarserThanTheMesh) {  // one to two chords a multiplier (NUMERICS 1)
    for (const double rise : {0.0, 1.0, 3.5}) {
        const int size = space_of({{0.0, 1.2}, {12.0, 1.2 + rise}}).size();
        EXPECT_GE(size - 1, 12.0 / 2.5);
        EXPECT_LE(size - 1, 12.0);
    }
}

TEST(MultiplierSpace, ChordsAreThoseOfElements) {
    const MultiplierSpace space = space_of({{0.0, 1.2}, {12.0, 4.2}});
    const double chord = 1.0 / std::cos(std::atan(3.0 / 12.0));
    for (const double length : space.chords()) EXPECT_NEAR(length, chord, 1e-12);
}

TEST(MultiplierSpace, MouthKeepsItsHatAndATipFoldsIts) {
    constexpr double length = 11.9;
    const MultiplierSpace space = space_of({{0.0, 2.4}, {length, 2.4}});
    EXPECT_EQ(space.nodes().front(), 0.0);
    EXPECT_LT(space.nodes().back(), length - 0.9);
    const std::set<int> last = acting_between(space, space.nodes().back(), length);
    EXPECT_EQ(last, std::set<int>{space.size() - 1});  // constant pressure over the last interval
}

TEST(MultiplierSpace, FewIntervalsBetweenTwoTipsCarryOneConstant) {  // 0, 1 and 2 intervals
    for (const double length : {0.9, 1.9, 2.9}) {
        const MultiplierSpace space = space_of({{3.3, 2.4}, {3.3 + length, 2.4}});
        ASSERT_EQ(space.size(), 1) << length;
        EXPECT_NEAR(space.nodes()[0], 0.5 * length, 1e-12);
        for (const double s : {0.01, 0.3, length - 0.01}) EXPECT_EQ(space.at(s)[0].value, 1.0);
    }
}

TEST(MultiplierSpace, ManyIntervalsBetweenTwoTipsFoldBoth) {
    const MultiplierSpace space = space_of({{1.3, 2.4}, {10.6, 2.4}});
    EXPECT_GE(space.size(), 3);
    EXPECT_GT(space.nodes().front(), 1.0);
    EXPECT_LT(space.nodes().back(), 8.3);
}

TEST(MultiplierSpace, AKinkBreaksThePressure) {
    const double corner = 6.0;
    const MultiplierSpace kinked = space_of({{0.0, 1.4}, {corner, 1.4}, {10.0, 5.4}});
    const std::set<int> before = acting_between(kinked, 0.0, corner), after = acting_between(kinked, corner, 10.0);
    for (const int multiplier : before) EXPECT_FALSE(after.contains(multiplier));
    const MultiplierSpace bent = space_of({{0.0, 1.4}, {corner, 1.4}, {11.5, 1.9}});  // 5 degrees
    EXPECT_EQ(bent.at(corner)[0].multiplier, bent.at(corner + 1e-6)[0].multiplier);
}

TEST(MultiplierSpace, ANotchCarriesNone) {
    const MultiplierSpace space = space_of({{0.0, 2.4}, {12.0, 2.4}}, 4.7);
    EXPECT_EQ(sum_at(space, 4.6), 0.0);
    EXPECT_EQ(space.nodes().front(), 4.7);
    for (const double s : {4.7, 5.0, 12.0}) EXPECT_NEAR(sum_at(space, s), 1.0, 1e-14);
}

TEST(MultiplierSpace, ABranchShorterThanThreeQuartersOfAChordJoinsItsNeighbour) {
    const MultiplierSpace space = space_of({{0.0, 2.5}, {11.5, 2.5}, {12.0, 3.0}});
    const std::set<int> last = acting_between(space, 11.5, 11.5 + std::sqrt(0.5));
    const std::set<int> before = acting_between(space, 10.5, 11.5);
    for (const int multiplier : last) EXPECT_TRUE(before.contains(multiplier));
}

}  // namespace
}  // namespace stria::test
