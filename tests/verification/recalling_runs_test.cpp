// What runs of metal that recalls its back stresses cost beside runs of Prager's.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <ctime>
#include <iostream>
#include <vector>

#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

const std::vector<std::string> two_back_stresses_and_voce{
    "material.kinematic=[{C=60e3, gamma=300.0}, {C=4e3, gamma=20.0}]",
    "material.isotropic={law=\"voce\", Q=60.0, b=10.0}"};

// What a run costs beside Prager's metal, in counts: the crack grows and closes in each of four cycles.
TEST(CyclicHardening, AClosureRunWithTwoBackStressesLosesNoIncrement) {
    const auto iterations = [](const std::vector<std::string>& metal) {
        std::vector<std::string> scene{mesh_at_tip(0.4), "load.blocks=[{cycles=4, max=45.0, ratio=0.0}]",
                                       "growth.increment=0.4", "closure.distance=0.5"};
        scene.insert(scene.end(), metal.begin(), metal.end());
        const RunHistory run = run_direct(sent_case(scene));
        EXPECT_EQ(run.cuts, 0);
        int count = 0;
        for (const auto& [step, report] : run.attempts) count += report.count();
        return count;
    };
    const int prager = iterations({"material.kinematic=[{C=4000.0}]"}),
              recalling = iterations(two_back_stresses_and_voce);
    EXPECT_LT(recalling, 1.1 * prager);
}

// The same of a crack that grows through small elements (bench/growing_cycle). What a point costs more is told beside
// it: in plane strain Prager's metal returns in closed form.
TEST(CyclicHardening, TwoBackStressesAskForLittleMoreThanPragersLong) {
    struct Effort {
        std::int64_t iterations = 0, points = 0;
        double seconds = 0.0;
    };
    const auto effort_of = [](const char* plane, const std::vector<std::string>& metal) {
        std::vector<std::string> scene{fmt::format("model.plane={}", plane),
                                       "load.blocks=[{cycles=5, max=50.0, ratio=0.0}]"};
        scene.insert(scene.end(), metal.begin(), metal.end());
        const Case input = read_case(std::string(source_folder) + "/bench/growing_cycle/case.toml", scene);
        const std::clock_t start = std::clock();
        const RunHistory run = run_direct(input);
        Effort effort{.points = run.increments.back().zone.work.points_evaluated};
        for (const auto& [step, report] : run.attempts) effort.iterations += report.count();
        effort.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        return effort;
    };
    for (const char* plane : {"strain", "stress"}) {
        const Effort prager = effort_of(plane, {}), recalling = effort_of(plane, two_back_stresses_and_voce);
        std::cout << fmt::format(
            "plane {}, Prager, two back stresses and Voce: {} and {} iterations, {} and {} points, "
            "{:.2f} and {:.2f} s\n",
            plane, prager.iterations, recalling.iterations, prager.points, recalling.points, prager.seconds,
            recalling.seconds);
        EXPECT_LT(10 * recalling.iterations, 11 * prager.iterations) << plane;
        EXPECT_LT(10 * recalling.points, 11 * prager.points) << plane;
    }
}

}  // namespace
}  // namespace stria::test
