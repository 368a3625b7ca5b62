// What load.accuracy promises: the range of the opening behind the tip, cycle by cycle, with the increments that the
// program chooses, against many given ones (docs/verification/increments.md).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "common/case/schema/case_file.hpp"
#include "tests/support/folders.hpp"
#include "tests/support/load_cases.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

constexpr double accuracy = 0.002;  // load.accuracy by default

std::vector<coarse::CycleResult> cycles_of(const std::string& scene, std::vector<std::string> settings) {
    return run_cycles(read_case(std::string(source_folder) + scene, std::move(settings)));
}

/// Of each of the cycles from the fourth on, in which the increments are measured, against 96 increments of a leg.
void expect_accuracy(const std::string& scene, const std::vector<std::string>& settings, double of_K_op, double of_J) {
    std::vector<std::string> many = settings;
    many.insert(many.end(), {"load.steps=96", "load.grading=0.4"});
    const std::vector<coarse::CycleResult> chosen = cycles_of(scene, settings), exact = cycles_of(scene, many);
    ASSERT_EQ(chosen.size(), exact.size());
    ASSERT_GT(chosen.size(), 4);
    for (std::size_t k = 4; k < chosen.size(); ++k) {
        const coarse::CycleResult &ours = chosen[k], &reference = exact[k];
        EXPECT_NEAR(ours.opening_range() / reference.opening_range(), 1.0, accuracy) << "cycle " << k + 1;
        EXPECT_NEAR(ours.contact.at(0).K_op / ours.K_max, reference.contact.at(0).K_op / reference.K_max, of_K_op)
            << "cycle " << k + 1;
        EXPECT_NEAR(ours.J_max / reference.J_max, 1.0, of_J) << "cycle " << k + 1;
    }
}

TEST(ChosenIncrements, KeepTheAccuracyOfACrackThatGrows) {
    expect_accuracy("/bench/growing_cycle/case.toml", {"load.blocks=[{cycles=5, max=50.0, ratio=0.0}]"}, 0.005, 2e-4);
}

TEST(ChosenIncrements, KeepTheAccuracyOfFacesThatAreClosedHalfOfTheTimeLong) {
    expect_accuracy("/cases/sent-closure/case.toml", {"load.blocks.0.ratio=-1.0"}, 0.005, 2e-4);
}

// Beside a dead load legs are as straight as without it. With 12 increments a cycle, whatever it was, the opening range
// was 0.8 % off and K_op 0.016 of K_max.
TEST(ChosenIncrements, AreThoseOfTheRunInWhichTheLoadBeginsHigher) {
    const std::vector<std::string> settings{"fine.refine=8", "growth.increment=0.2"};
    const auto cycles = [&](double max, double min, double dead) {
        std::vector<std::string> all = settings;
        all.push_back(fmt::format("load.blocks=[{{cycles=6, max={}, min={}}}]", max, min));
        Case input = read_case(std::string(source_folder) + "/bench/growing_cycle/case.toml", all);
        if (dead != 0.0) {
            input.load_cases = {dead_load("dead", dead)};
            for (const auto& [on, sign] : {std::pair("top", 1.0), std::pair("bottom", -1.0)})
                input.boundaries.push_back(pulled_in_case("dead", on, {0.0, sign}));
        }
        return run_cycles(input);
    };
    const std::vector<coarse::CycleResult> expected = cycles(50.0, -50.0, 0.0), found = cycles(80.0, -20.0, -30.0);
    for (std::size_t k = 4; k < expected.size(); ++k) {
        EXPECT_NEAR(found[k].opening_range() / expected[k].opening_range(), 1.0, 0.5 * accuracy) << "cycle " << k + 1;
        EXPECT_NEAR(found[k].opening.K_op, expected[k].opening.K_op, 0.004 * expected[k].K_max) << "cycle " << k + 1;
    }
}

/// What friction dissipates in three cycles between pulling and pressing a plate with a crack at 45 degrees that grows,
/// N.
double work_of_friction(std::optional<int> steps) {
    Case input = specimen("plate", 80.0, {{32.93, 32.94}, {47.07, 47.06}});
    input.mesh.width = 80.0;
    input.mesh.size = 2.0;
    input.material.young = 200e3;
    input.material.yield_stress = 300.0;
    input.material.kinematic = {{.C = 4000.0}};
    input.cracks[0].contact = ContactSection{.friction = 0.3};
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    input.load.blocks = {{.cycles = 3, .max = 80.0, .min = -80.0}};
    input.growth = GrowthSection{.increment = 0.25};
    input.fine.refine = 4;
    if (steps) {
        input.load.steps = *steps;
        input.load.grading = 1.0;
    }
    return run_direct(input).increments.back().work.by_friction;
}

// Half of the way in one increment, as in a half cycle without friction, lost a third of it. 16 a cycle lose 1.01 %; it
// was 0.86 % while the loads at which faces meet were those of both tips together.
TEST(ChosenIncrements, TellTheWorkOfFacesThatSlideUnderPressure) {
    const double exact = work_of_friction(96);
    EXPECT_GT(exact, 1.0);
    EXPECT_NEAR(work_of_friction({}), exact, 0.012 * exact);
}

/// What is dissipated in two cycles of tension and, a quarter of a cycle later, shear, N.
double dissipated_out_of_phase(std::vector<std::string> settings) {
    settings.insert(settings.end(), {"mesh.size=4", "load.blocks.0.cycles=2"});
    const std::string file = std::string(source_folder) + "/bench/out_of_phase/case.toml";
    return run_direct(read_case(file, settings)).increments.back().work.dissipated;
}

// By 12 increments that were large where the load turns, 8 % were missing.
TEST(ChosenIncrements, TellTheWorkOfLoadsThatRunAlongACurve) {
    const double exact = dissipated_out_of_phase({"load.steps=96"});
    EXPECT_GT(exact, 1.0);
    EXPECT_NEAR(dissipated_out_of_phase({}), exact, 0.015 * exact);
}

/// What friction takes in four cycles of a crack that one load case presses and another one shears, N.
double dissipated_under_pressing_case(int steps) {
    const std::string file = std::string(source_folder) + "/bench/pressed_by_a_case/case.toml";
    return run_direct(read_case(file, {fmt::format("load.steps={}", steps)})).increments.back().work.dissipated;
}

// By increments that were large where the load turns 1.2 % were missing.
TEST(ChosenIncrements, AreEqualWhereALoadCasePresses) {
    const double exact = dissipated_under_pressing_case(96);
    EXPECT_GT(exact, 1.0);
    EXPECT_NEAR(dissipated_under_pressing_case(8), exact, 0.003 * exact);
}

}  // namespace
}  // namespace stria::test
