// Which elements of a tree stand together, and that they stay together where others come and go.
#include "common/substructure/bisection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

#include "common/index.hpp"

namespace stria {
namespace {

/// Squares of one millimetre, in rows along x.
FrontLayout strip(int columns, int rows) {
    FrontLayout layout;
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) layout.centres.emplace_back(i + 0.5, j + 0.5);
    layout.element_unknowns.resize(layout.centres.size());
    return layout;
}

/// The places of each leaf's elements.
using Leaf = std::set<std::pair<double, double>>;
std::set<Leaf> leaves(const FrontLayout& layout) {
    std::set<Leaf> found;
    for (const PartOfElements& node : bisect(layout)) {
        Leaf leaf;
        for (const int e : node.elements) leaf.emplace(layout.centres[at(e)].x(), layout.centres[at(e)].y());
        if (!node.elements.empty()) found.insert(leaf);
    }
    return found;
}

TEST(Bisection, CutsAtTheRoundestNumberAboveOneAndNotAboveTheOther) {
    EXPECT_EQ(roundest_between(3.3, 4.9), 4.0);
    EXPECT_EQ(roundest_between(3.0, 4.0), 4.0);
    EXPECT_EQ(roundest_between(4.0, 4.3), 4.25);
    EXPECT_EQ(roundest_between(5.1, 7.9), 6.0);
    EXPECT_EQ(roundest_between(-0.3, 0.7), 0.0);
    EXPECT_EQ(roundest_between(-7.9, -5.1), -6.0);
    EXPECT_EQ(roundest_between(0.0, 3e-20), std::ldexp(1.0, -65));
}

TEST(Bisection, HoldsEachElementOnceInLeavesThatAreNeitherTooLargeNorNearlyEmpty) {
    for (const int columns : {1, 13, 90}) {
        const FrontLayout layout = strip(columns, 7);
        std::vector<int> elements;
        for (const PartOfElements& node : bisect(layout)) {
            if (node.elements.empty()) continue;
            EXPECT_LE(std::ssize(node.elements), layout.leaf_elements);
            EXPECT_GE(std::ssize(node.elements), 4);
            EXPECT_TRUE(std::ranges::is_sorted(node.elements));
            elements.insert(elements.end(), node.elements.begin(), node.elements.end());
        }
        std::ranges::sort(elements);
        std::vector<int> all(layout.centres.size());
        std::iota(all.begin(), all.end(), 0);
        EXPECT_EQ(elements, all);
    }
}

TEST(Bisection, CopesWithElementsAtOnePlace) {
    FrontLayout layout;
    layout.centres.assign(100, Vec2(1.0, 2.0));
    layout.element_unknowns.resize(100);
    for (const PartOfElements& node : bisect(layout)) EXPECT_LE(std::ssize(node.elements), layout.leaf_elements);
}

// Median halves would move all borders with each column that joins.
TEST(Bisection, LeavesMostPartsAsTheyAreWhereElementsJoin) {
    const std::set<Leaf> before = leaves(strip(100, 6)), after = leaves(strip(101, 6));
    const auto stays = [&](const Leaf& leaf) { return before.contains(leaf); };
    EXPECT_GE(std::ranges::count_if(after, stays), 4 * std::ssize(after) / 5);
}

TEST(Bisection, DoesNotGoByTheNumbersOfElements) {
    FrontLayout layout = strip(31, 6);
    const std::set<Leaf> before = leaves(layout);
    std::ranges::reverse(layout.centres);
    EXPECT_EQ(leaves(layout), before);
}

}  // namespace
}  // namespace stria
