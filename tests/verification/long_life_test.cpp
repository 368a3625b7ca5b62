// A crack that grows through a hundred elements in a thousand cycles: what a cycle costs does not depend on how many
// there were before it.
#include <gtest/gtest.h>

#include <chrono>
#include <fmt/format.h>
#include <iostream>
#include <numeric>
#include <vector>

#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "tests/support/sent_analysis.hpp"

#include "common/index.hpp"
#include "tests/support/folders.hpp"

namespace stria::test {
namespace {

/// A plate whose crack grows by `growth` in every one of so many cycles, in elements of 0.1 mm, with contact.
struct Life {
    int cycles;
    double growth;  // mm
    int every;      // cycles
    const char* steps = "12";
};

struct LivedCycles {
    std::vector<int> iterations;  // by cycle, what only measures and is rolled back included
    std::vector<double> seconds;  // since the start, at the end of each
    std::vector<double> a;        // mm
    std::vector<double> points;   // return mappings since the start, at the end of each
    int cuts = 0;

    [[nodiscard]] int in_cycles(int from, int to) const {
        return std::accumulate(iterations.begin() + from, iterations.begin() + to + 1, 0);
    }
    [[nodiscard]] double points_in(int from, int to) const { return points[at(to)] - points[at(from - 1)]; }
    [[nodiscard]] std::string text(int from, int to) const {
        return fmt::format("cycles {} to {}: {} iterations, {} points, {:.2f} s", from, to, in_cycles(from, to),
                           points_in(from, to), seconds[at(to)] - seconds[at(from - 1)]);
    }
};

LivedCycles live(const Life& life) {
    const Case input =
        read_case(std::string(test::source_folder) + "/cases/sent-closure/case.toml",
                  {fmt::format("load.steps={}", life.steps), "crack.0.points=[[0.0, 100.03], [20.0, 100.03]]",
                   fmt::format("load.blocks=[{{cycles={}, max=501.0, ratio=0.0}}]", life.cycles), "fine.refine=16",
                   fmt::format("growth.increment={}", life.growth), fmt::format("growth.every={}", life.every),
                   "closure.profile=[]", "closure.distance=0.1"});
    use_one_thread();
    const coarse::Scene scene = coarse::refined_scene(input);
    fine::FineModel fine(input);
    coarse::CondensedFactory factory(&fine, input);
    LivedCycles effort{std::vector<int>(at(life.cycles) + 1), std::vector<double>(at(life.cycles) + 1),
                       std::vector<double>(at(life.cycles) + 1), std::vector<double>(at(life.cycles) + 1)};
    coarse::Listener listener;
    listener.attempted = [&](const coarse::LoadStep& step, const coarse::NewtonReport& report) {
        effort.iterations[at(step.cycle)] += report.count();
    };
    const auto start = std::chrono::steady_clock::now();
    listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure&) {
        const auto cycle = at(increment.step.cycle);
        effort.seconds[cycle] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        effort.a[cycle] = increment.tips[0].a;
        effort.points[cycle] = static_cast<double>(increment.zone.work.points_evaluated);
    };
    coarse::FatigueAnalysis analysis(scene, factory, listener);
    analysis.run();
    effort.cuts = analysis.cuts();
    return effort;
}

TEST(LongLife, AThousandCyclesCostWhatTheFirstOnesDoLong) {
    const LivedCycles effort = live({.cycles = 1000, .growth = 0.1, .every = 10});
    std::cout << fmt::format("{}; {}; a = {:.2f} mm, {} halved increments\n", effort.text(21, 30),
                             effort.text(991, 1000), effort.a[1000], effort.cuts);
    EXPECT_GT(effort.a[1000], 29.85);
    EXPECT_EQ(effort.cuts, 0);
    EXPECT_LE(effort.in_cycles(991, 1000), 1.2 * effort.in_cycles(21, 30));
    EXPECT_LE(effort.points_in(991, 1000), 2.0 * effort.points_in(21, 30));
}

// The program chooses the increments.
TEST(LongLife, SoDoFiveHundredThatGrowInEachLong) {
    const LivedCycles effort = live({.cycles = 500, .growth = 0.02, .every = 1, .steps = "\"auto\""});
    std::cout << fmt::format("{}; {}; a = {:.2f} mm, {} halved increments\n", effort.text(21, 30),
                             effort.text(491, 500), effort.a[500], effort.cuts);
    EXPECT_GT(effort.a[500], 29.97);
    EXPECT_LE(effort.in_cycles(491, 500), 1.15 * effort.in_cycles(21, 30));
    EXPECT_LE(effort.points_in(491, 500), 1.15 * effort.points_in(21, 30));
}

TEST(LongLife, FourteenCyclesThatGrowInEachCostWhatTheFirstOnesDo) {
    const LivedCycles effort = live({.cycles = 14, .growth = 0.1, .every = 1});
    std::cout << fmt::format("{}; {}; a = {:.2f} mm, {} halved increments\n", effort.text(4, 8), effort.text(10, 14),
                             effort.a[14], effort.cuts);
    EXPECT_NEAR(effort.a[14], 21.4, 1e-9);
    EXPECT_LE(effort.cuts, 1);
    EXPECT_LE(effort.in_cycles(10, 14), 1.1 * effort.in_cycles(4, 8));  // without predictors 12 % more
}

}  // namespace
}  // namespace stria::test
