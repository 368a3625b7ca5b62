// Which elements of a tree stand together, and that they stay together where others come and go.
#include "common/substructure/bisection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
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

/// Of the part of the tree under a node.
std::vector<int> elements_under(const std::vector<PartOfElements>& nodes, int node) {
    std::vector<int> found = nodes[at(node)].elements;
    for (const int child : nodes[at(node)].children) {
        if (child < 0) continue;
        const std::vector<int> more = elements_under(nodes, child);
        found.insert(found.end(), more.begin(), more.end());
    }
    return found;
}

/// Adds squares of one millimetre with an unknown at each corner.
void add_block(FrontLayout& layout, std::map<std::pair<int, int>, int>& corners, int x, int y, int columns, int rows) {
    for (int i = x; i < x + columns; ++i) {
        for (int j = y; j < y + rows; ++j) {
            std::vector<int>& unknowns = layout.element_unknowns.emplace_back();
            for (const auto& corner : {std::pair(i, j), {i + 1, j}, {i + 1, j + 1}, {i, j + 1}})
                unknowns.push_back(corners.try_emplace(corner, static_cast<int>(std::ssize(corners))).first->second);
            layout.centres.emplace_back(i + 0.5, j + 0.5);
        }
    }
    layout.unknowns = static_cast<int>(std::ssize(corners));
}

// Halves of as many elements would share a row of the larger block.
TEST(Bisection, CutsWherePartsShareFewUnknowns) {
    FrontLayout layout;
    std::map<std::pair<int, int>, int> corners;
    add_block(layout, corners, 0, 0, 9, 8);
    add_block(layout, corners, 9, 3, 2, 1);
    add_block(layout, corners, 11, 0, 15, 8);
    const std::vector<PartOfElements> nodes = bisect(layout);
    std::vector<std::set<int>> unknowns;
    for (const int child : nodes.back().children) {
        std::set<int>& of_child = unknowns.emplace_back();
        for (const int e : elements_under(nodes, child))
            of_child.insert(layout.element_unknowns[at(e)].begin(), layout.element_unknowns[at(e)].end());
    }
    const auto shared = [&](int unknown) { return unknowns[1].contains(unknown); };
    EXPECT_EQ(std::ranges::count_if(unknowns[0], shared), 2);
}

// Its rim is the shortest about so many.
TEST(Bisection, PartsASquareAboutABusyPlace) {
    FrontLayout layout;
    std::map<std::pair<int, int>, int> corners;
    add_block(layout, corners, 0, 0, 40, 40);
    layout.busy = {Vec2(17.5, 20.5)};
    const std::vector<PartOfElements> nodes = bisect(layout);
    const std::vector<int> near = elements_under(nodes, nodes.back().children[1]);
    EXPECT_EQ(near.size(), 121U);
    for (const int e : near) EXPECT_LE((layout.centres[at(e)] - layout.busy[0]).lpNorm<Eigen::Infinity>(), 5.0);
}

// A front that waits for both squares would keep the rims of both, and be factored whenever one changes.
TEST(Bisection, PartsBusyPlacesFromEachOtherBeforeWhatLiesAboutThem) {
    for (const int columns_between : {0, 60}) {  // joined, apart
        FrontLayout layout;
        std::map<std::pair<int, int>, int> corners;
        const int second = 30 + columns_between;
        add_block(layout, corners, 0, 0, 30, 20);
        add_block(layout, corners, second, 0, 30, 20);
        layout.busy = {Vec2(second + 14.5, 9.5), Vec2(14.5, 9.5)};
        const std::vector<PartOfElements> nodes = bisect(layout);
        for (const double x : {14.5, second + 14.5}) {
            const std::array<int, 2> sides = nodes.back().children;
            const int side = sides[x < second ? 0 : 1];
            const std::vector<int> near = elements_under(nodes, nodes[at(side)].children[1]);
            EXPECT_EQ(near.size(), 121U);
            for (const int e : near) EXPECT_LE((layout.centres[at(e)] - Vec2(x, 9.5)).lpNorm<Eigen::Infinity>(), 5.0);
        }
    }
}

// As tips have that came to lie in one element.
TEST(Bisection, CopesWithBusyPlacesThatAreOne) {
    FrontLayout layout;
    std::map<std::pair<int, int>, int> corners;
    add_block(layout, corners, 0, 0, 40, 40);
    layout.busy = {Vec2(17.5, 20.5)};
    const std::set<Leaf> once = leaves(layout);
    layout.busy.push_back(layout.busy.front());
    EXPECT_EQ(leaves(layout), once);
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
    for (int k = 0; k < 100; k += 2) layout.centres[at(k)].x() = std::nextafter(1.0, 2.0);
    for (const PartOfElements& node : bisect(layout)) EXPECT_LE(std::ssize(node.elements), layout.leaf_elements);
}

// Median halves would move all borders with each column that joins.
TEST(Bisection, LeavesMostPartsAsTheyAreWhereElementsJoin) {
    const std::set<Leaf> before = leaves(strip(100, 6)), after = leaves(strip(101, 6));
    const auto stays = [&](const Leaf& leaf) { return before.contains(leaf); };
    EXPECT_GE(std::ranges::count_if(after, stays), 4 * std::ssize(after) / 5);
}

// Nodes of one to three unknowns: those of a node follow each other in all elements, or in none.
TEST(Bisection, DoesNotGoByTheOrderOfUnknowns) {
    FrontLayout corners, layout;
    std::map<std::pair<int, int>, int> numbers;
    add_block(corners, numbers, 0, 0, 23, 17);
    layout.centres = corners.centres;
    const auto count = [](int corner) { return 1 + corner * corner % 7 % 3; };
    std::vector<int> first;
    for (int corner = 0; corner < corners.unknowns; ++corner) {
        first.push_back(layout.unknowns);
        layout.unknowns += count(corner);
    }
    for (const std::vector<int>& own : corners.element_unknowns) {
        std::vector<int>& unknowns = layout.element_unknowns.emplace_back();
        for (const int corner : own)
            for (int k = 0; k < count(corner); ++k) unknowns.push_back(first[at(corner)] + k);
    }
    FrontLayout shuffled = layout;
    std::mt19937 random(1);
    for (std::vector<int>& unknowns : shuffled.element_unknowns) std::ranges::shuffle(unknowns, random);
    EXPECT_EQ(leaves(shuffled), leaves(layout));
}

TEST(Bisection, DoesNotGoByTheNumbersOfElements) {
    FrontLayout layout = strip(31, 6);
    const std::set<Leaf> before = leaves(layout);
    std::ranges::reverse(layout.centres);
    EXPECT_EQ(leaves(layout), before);
}

}  // namespace
}  // namespace stria
