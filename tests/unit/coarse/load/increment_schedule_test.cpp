// Increments that the program chooses: how a path bends where a leg ends, and how many increments are near enough
// there.
#include "coarse/load/increment_schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "coarse/load/load_controller.hpp"

namespace stria::coarse {
namespace {

using Opening = std::function<double(double)>;

OpeningPath path_over(const std::vector<double>& ways, const Opening& opening) {
    OpeningPath path;
    path.begin({opening(0.0)});
    for (std::size_t k = 1; k < ways.size(); ++k) path.add(ways[k], {opening(ways[k])});
    return path;
}

// o = 1 + 3 w + a w^2 has o'' = 2 a and the range 3 + a, whatever the increments.
TEST(IncrementSchedule, KnowsHowAPathBendsAtItsEnd) {
    for (const double a : {0.5, 2.0, 20.0})
        for (const int increments : {3, 5, 12}) {
            const auto opening = [&](double w) { return 1.0 + w * (3.0 + a * w); };
            const OpeningPath path = path_over(graded_ways(increments, 0.4), opening);
            EXPECT_NEAR(*curvature_at_end(path), 2.0 * a / (3.0 + a), 1e-9);
        }
    const OpeningPath late = path_over(graded_ways(400, 1.0), [](double w) { return 1.0 + std::pow(w, 5); });
    EXPECT_NEAR(*curvature_at_end(late), 20.0, 0.2) << "5 * 4 w^3 at the end, not on the way";
}

TEST(IncrementSchedule, HearsTheTipThatBendsMostAndNoneThatTouches) {
    OpeningPath path;
    path.begin({1.0, 3.0});
    for (const double w : {0.5, 0.75, 1.0}) path.add(w, {1.0 + w * w, 3.0 - 3.0 * w * w * (2.0 - w)});
    EXPECT_NEAR(*curvature_at_end(path), 2.0, 1e-12) << "the second tip has closed";
    path.opening.front()[0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(curvature_at_end(path));
    EXPECT_FALSE(curvature_at_end(path_over(graded_ways(5, 0.4), [](double) { return 1.0; })));
    EXPECT_FALSE(curvature_at_end(OpeningPath()));
}

TEST(IncrementSchedule, GradesWaysAndKeepsTurns) {
    EXPECT_EQ(graded_ways(4, 1.0), (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
    EXPECT_EQ(graded_ways(4, 1.0, {0.6}), (std::vector<double>{0.0, 0.25, 0.6, 0.75, 1.0}));
    EXPECT_DOUBLE_EQ(graded_ways(2, 0.4)[1], std::pow(0.5, 0.4));
}

/// Increments of a leg that loads, after one that a schedule with these sections saw.
int after(const LoadSection& load, const Opening& opening, bool may_choose = true) {
    IncrementSchedule schedule(load, {}, may_choose);
    schedule.begin({opening(0.0)});
    const std::vector<double> ways = schedule.ways(true), falling = schedule.ways(false);
    for (std::size_t k = 1; k < ways.size(); ++k) schedule.add(ways[k], {opening(ways[k])});
    schedule.end_leg(true);
    EXPECT_EQ(schedule.ways(false), falling) << "legs of the other direction";
    return static_cast<int>(schedule.ways(true).size()) - 1;
}

TEST(IncrementSchedule, TakesWhatTheEndOfALegAsksFor) {
    const auto straight = [](double w) { return 1.0 + w; };
    const auto square = [](double w) { return 1.0 + w * w; };
    const int begins = LoadSection().first_steps() / 2;
    EXPECT_EQ(after({}, straight), begins - 1) << "one less at a time";
    // The last increment of h is off by 2 (1 - ((h - 1) / h)^0.4)^2 / 6.
    for (const double accuracy : {1e-3, 2e-4}) {
        const auto error = [](int h) { return std::pow(1.0 - std::pow((h - 1.0) / h, 0.4), 2) / 3.0; };
        const int chosen = after({.accuracy = accuracy, .blocks = {}}, square);
        EXPECT_LE(error(chosen), accuracy);
        EXPECT_GT(error(chosen - 1), accuracy);
        EXPECT_GT(chosen, begins);
    }
    EXPECT_EQ(after({.accuracy = 1e-9, .blocks = {}}, square), 24);
    EXPECT_EQ(after({.accuracy = 0.002, .blocks = {}}, square), begins)
        << "near enough, and one less would not clearly be";
}

TEST(IncrementSchedule, LeavesGivenNumbersAlone) {
    const auto bent = [](double w) { return 1.0 + std::pow(w, 9); };
    const int begins = LoadSection().first_steps() / 2;
    EXPECT_GT(after({}, bent), begins);
    EXPECT_EQ(after({.steps = 16, .blocks = {}}, bent), 8);
    EXPECT_EQ(after({}, bent, false), begins);
    EXPECT_EQ(after({}, [](double) { return std::numeric_limits<double>::quiet_NaN(); }), begins);
}

// Extremes stay exact, a leg that closes the faces follows the legs that open them, and a run that is gone on with has
// learned what the first one had.
TEST(IncrementSchedule, GuidesTheController) {
    const LoadSection load{.blocks = {{.cycles = 3, .max = 50.0 / 3.0, .min = -0.1}}};
    LoadController loads(load, {});
    std::vector<int> per_leg(1, 0);
    std::optional<LoadController> again;
    while (const auto step = loads.next()) {
        if (again) {
            EXPECT_EQ(again->next()->target.value, step->target.value);
        }
        const std::vector<double> openings = {std::pow((step->target.value + 0.1) / 10.0, 12)};
        loads.accepted(openings);
        if (again) again->accepted(openings);
        ++per_leg.back();
        if (!step->reversal) continue;
        EXPECT_TRUE(step->target.value == 50.0 / 3.0 || step->target.value == -0.1);
        per_leg.push_back(0);
        if (per_leg.size() == 4) {
            again.emplace(load, SolverSection());
            again->resume(loads.position());
        }
    }
    const int begins = load.first_steps() / 2;
    EXPECT_EQ(std::vector<int>(per_leg.begin(), per_leg.begin() + 4), std::vector<int>(4, begins))
        << "the ramp is no cycle, and the first cycle learns";
    EXPECT_GT(per_leg[4], begins);
    EXPECT_EQ(per_leg[5], per_leg[4]) << "closed at its end";
    EXPECT_EQ(per_leg[6], per_leg[4]) << "what has been learned stays";
}

}  // namespace
}  // namespace stria::coarse
