// The grid convergence index of a result.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "app/study/convergence/grid_convergence.hpp"

namespace stria::test {
namespace {

using study::Approach;
using study::grid_convergence;
using study::GridConvergence;
using study::GridValue;

/// limit + C h^p.
std::vector<GridValue> by_power(std::vector<double> sizes, double limit, double C, double p) {
    std::vector<GridValue> grids;
    for (const double h : sizes) grids.push_back({h, limit + C * std::pow(h, p)});
    return grids;
}

TEST(GridConvergence, FindsOrderAndLimitOfAPowerWhateverTheRatiosOfSizes) {
    for (const double p : {0.6, 1.0, 1.7}) {
        const GridConvergence found = grid_convergence(by_power({0.1, 0.35, 0.2}, 7.0, -3.0, p));
        EXPECT_EQ(found.approach, Approach::Monotone);
        EXPECT_NEAR(found.order, p, 1e-9);
        EXPECT_NEAR(found.limit, 7.0, 1e-9);
        EXPECT_NEAR(found.uncertainty, 1.25 * 3.0 * std::pow(0.1, p), 1e-9);
        EXPECT_EQ(found.finest, 7.0 - 3.0 * std::pow(0.1, p));
    }
}

// docs/references.md 9.1.
TEST(GridConvergence, IsThatOfTheJournalsExample) {
    const auto size = [](double cells) { return 1.0 / std::sqrt(cells); };
    const GridConvergence found = grid_convergence({{size(4500), 5.863}, {size(8000), 5.972}, {size(18000), 6.063}});
    EXPECT_NEAR(found.order, 1.53, 0.01);
    EXPECT_NEAR(found.limit, 6.1685, 5e-4);
    EXPECT_NEAR(found.uncertainty / found.finest, 0.022, 0.0005);
}

TEST(GridConvergence, TakesTheThreeSmallestSizes) {
    auto grids = by_power({0.1, 0.2, 0.4}, 7.0, 3.0, 1.0);
    const GridConvergence alone = grid_convergence(grids);
    grids.insert(grids.begin(), {0.8, -100.0});
    EXPECT_EQ(grid_convergence(grids).order, alone.order);
    EXPECT_EQ(grid_convergence(grids).limit, alone.limit);
}

TEST(GridConvergence, OfTwoSizesIsOfFirstOrderAndLessCertain) {
    const GridConvergence found = grid_convergence({{1.0, 130.0}, {0.5, 115.0}});
    EXPECT_EQ(found.approach, Approach::Assumed);
    EXPECT_EQ(found.limit, 2.0 * 115.0 - 130.0);
    EXPECT_EQ(found.uncertainty, 3.0 * 15.0);
    EXPECT_TRUE(std::isnan(found.order));
}

// A limit by the order of 0.2 would be twenty times the last difference away; one by the order of 6, next to nothing.
TEST(GridConvergence, ExtrapolatesByNoOrderThatSizesCannotShow) {
    const GridConvergence slow = grid_convergence(by_power({1.0, 2.0, 4.0}, 0.0, 1.0, 0.2));
    const double last = std::pow(2.0, 0.2) - 1.0;
    EXPECT_NEAR(slow.order, 0.2, 1e-9);
    EXPECT_NEAR(slow.limit, 1.0 - last / (std::sqrt(2.0) - 1.0), 1e-12);
    EXPECT_NEAR(slow.uncertainty, 3.0 * last / (std::sqrt(2.0) - 1.0), 1e-12);
    const GridConvergence fast = grid_convergence(by_power({1.0, 2.0, 4.0}, 0.0, 1.0, 6.0));
    EXPECT_NEAR(fast.order, 6.0, 1e-9);
    EXPECT_NEAR(fast.uncertainty, 3.0 * 63.0 / 3.0, 1e-9);
}

TEST(GridConvergence, TellsWhatDoesNotConverge) {
    const GridConvergence swings = grid_convergence({{1.0, 10.0}, {2.0, 11.0}, {4.0, 9.0}});
    EXPECT_EQ(swings.approach, Approach::Oscillating);
    EXPECT_TRUE(std::isnan(swings.limit));
    EXPECT_EQ(swings.uncertainty, 6.0);
    const GridConvergence leaves = grid_convergence({{1.0, 10.0}, {2.0, 8.0}, {4.0, 7.0}});
    EXPECT_EQ(leaves.approach, Approach::Away);
    EXPECT_TRUE(std::isnan(leaves.limit) && std::isnan(leaves.uncertainty));
    // Differences alike go away where the sizes halve, and shrink with them where the larger ones are close together.
    EXPECT_EQ(grid_convergence({{1.0, 10.0}, {2.0, 8.0}, {4.0, 6.0}}).approach, Approach::Away);
    EXPECT_EQ(grid_convergence({{1.0, 10.0}, {2.0, 8.0}, {3.0, 6.0}}).approach, Approach::Monotone);
}

TEST(GridConvergence, KnowsWhatNoSizeChanges) {
    for (const std::vector<GridValue>& grids :
         {std::vector<GridValue>{{1.0, 5.0}, {2.0, 5.0 + 1e-12}}, {{1.0, 5.0}, {2.0, 5.0}, {4.0, 5.0 - 1e-12}}}) {
        EXPECT_EQ(grid_convergence(grids).approach, Approach::Same);
        EXPECT_EQ(grid_convergence(grids).uncertainty, 0.0);
    }
    // Alike on the last two alone: converged, as far as these show.
    EXPECT_EQ(grid_convergence({{1.0, 5.0}, {2.0, 5.0}, {4.0, 6.0}}).limit, 5.0);
}

TEST(GridConvergence, WantsTwoSizes) {
    EXPECT_THROW(grid_convergence({{1.0, 5.0}}), std::invalid_argument);
    EXPECT_THROW(grid_convergence({{1.0, 5.0}, {1.0, 6.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace stria::test
