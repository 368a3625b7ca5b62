// A crack that grows through a hundred elements in a thousand cycles: what a cycle costs does not depend on how many
// there were before it.
#include <gtest/gtest.h>

#include <chrono>
#include <fmt/format.h>
#include <iostream>
#include <vector>

#include "coarse/zone/refined_scene.hpp"
#include "tests/support/sent_analysis.hpp"

#include "common/index.hpp"
#include "tests/support/folders.hpp"

namespace stria::test {
namespace {

TEST(LongLife, AThousandCyclesCostWhatTheFirstOnesDoLong) {
    const Case input =
        read_case(std::string(test::source_folder) + "/cases/sent-closure/case.toml",
                  {"load.steps=12", "crack.0.points=[[0.0, 100.03], [20.0, 100.03]]",
                   "load.blocks=[{cycles=1000, max=501.0, ratio=0.0}]", "fine.refine=16", "growth.increment=0.1",
                   "growth.every=10", "closure.profile=[]", "closure.distance=0.1"});
    use_one_thread();
    const coarse::Scene scene = coarse::refined_scene(input);
    fine::FineModel fine(input);
    coarse::CondensedFactory factory(&fine, input);
    std::vector<int> iterations(1001, 0);  // by cycle, what only measures and is rolled back included
    std::vector<double> seconds(1001, 0.0), a(1001, 0.0);
    coarse::Listener listener;
    listener.attempted = [&](const coarse::LoadStep& step, const coarse::NewtonReport& report) {
        iterations[at(step.cycle)] += report.count();
    };
    const auto start = std::chrono::steady_clock::now();
    listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure&) {
        const auto cycle = at(increment.step.cycle);
        seconds[cycle] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        a[cycle] = increment.tips[0].a;
    };
    coarse::FatigueAnalysis analysis(scene, factory, listener);
    analysis.run();
    const auto in_cycles = [&](int from, int to) {
        int sum = 0;
        for (int cycle = from; cycle <= to; ++cycle) sum += iterations[at(cycle)];
        return sum;
    };
    std::cout << fmt::format(
        "cycles 21 to 30: {} iterations, {:.2f} s; 991 to 1000: {} iterations, {:.2f} s; a = {:.2f} mm, "
        "{} halved increments\n",
        in_cycles(21, 30), seconds[30] - seconds[20], in_cycles(991, 1000), seconds[1000] - seconds[990], a[1000],
        analysis.cuts());
    EXPECT_GT(a[1000], 29.85);
    EXPECT_EQ(analysis.cuts(), 0);
    EXPECT_LE(in_cycles(991, 1000), 1.2 * in_cycles(21, 30));
}

}  // namespace
}  // namespace stria::test
