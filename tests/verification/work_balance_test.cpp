// The work that loads do comes out again: stored, dissipated, or released by a growing crack.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iostream>

#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

/// Of a run, N (per mm of thickness).
struct Balance {
    coarse::WorkBalance end;
    double largest_error = 0.0, largest_work = 0.0;

    [[nodiscard]] double relative_error() const { return largest_error / largest_work; }
};

Balance balance_of(const Case& input) {
    const RunHistory run = run_direct(input);
    Balance balance;
    for (const coarse::Increment& increment : run.increments) {
        balance.largest_error = std::max(balance.largest_error, std::abs(increment.work.error()));
        balance.largest_work = std::max(balance.largest_work, increment.work.external);
    }
    balance.end = run.increments.back().work;
    const coarse::WorkBalance& end = balance.end;
    std::cout << fmt::format("{:3} increments a cycle: external {:.6f} = stored {:.6f} + dissipated {:.6f} + released "
                             "{:.6f} + {:+.6f} N; largest error {:.4f} % of the largest external work\n",
                             input.load.steps, end.external, end.stored, end.dissipated, end.released, end.error(),
                             100.0 * balance.relative_error());
    return balance;
}

/// The shipped case on a coarser mesh, by default with 0.05 mm of growth a cycle.
Case cycled(double element, int cycles, int steps, double growth = 0.05) {
    Case input = sent_case({mesh_at_tip(element), "load.steps=" + std::to_string(steps),
                            "load.blocks=[{cycles=" + std::to_string(cycles) + ", max=50.0, ratio=-1.0}]"});
    if (growth > 0.0) input.growth.emplace().increment = growth;
    return input;
}

TEST(WorkBalance, ClosesOverTenGrownCycles) {
    const Balance balance = balance_of(cycled(0.2, 10, 20));
    EXPECT_LT(balance.relative_error(), 1e-3);
    EXPECT_GT(balance.end.released, 0.0);
}

TEST(WorkBalance, ClosesTheBetterTheSmallerTheIncrements) {
    double before = 1e300;
    for (const int steps : {12, 24, 48}) {
        const double error = balance_of(cycled(0.4, 2, steps, 0.0)).relative_error();
        EXPECT_LT(error, 0.6 * before);
        before = error;
    }
}

TEST(WorkBalance, CountsHardeningInPlaneStressAndBothKinds) {
    Case input = cycled(0.4, 2, 40);
    input.model.plane = PlaneState::Stress;
    input.material.isotropic.modulus = 2000.0;
    EXPECT_LT(balance_of(input).relative_error(), 1e-3);
}

/// A linear body with a zone, its crack growing thrice by 0.031 of its width, five of its smallest elements.
Case linear(End end) {
    Case input = edge_crack(0.3, 3.0, end);
    input.mesh.size = 1.0 / 21.0;
    input.fine.refine = 8;
    input.load = {.steps = 2, .blocks = {{.cycles = 3, .max = 100.0, .min = 10.0}}};
    input.growth.emplace().increment = 0.031;
    return input;
}

// K^2 / E' for each unit of length, less what the frozen functions of the old tip keep from opening: 8 % where a step
// spans one element or two.
TEST(WorkBalance, ReleasesInALinearBodyWhatItsStressIntensitySays) {
    for (const End end : {End::Pulled, End::Guided, End::Clamped}) {
        const RunHistory run = run_direct(linear(end));
        double irwin = 0.0;
        for (std::size_t i = 1; i < run.increments.size(); ++i) {
            const coarse::TipResult &from = run.increments[i - 1].tips[0], &to = run.increments[i].tips[0];
            irwin += 0.5 * (from.K_I * from.K_I + to.K_I * to.K_I) / plane_modulus * (to.a - from.a);
        }
        const coarse::WorkBalance& end_of_run = run.increments.back().work;
        std::cout << fmt::format("released {:.6g} N, by K {:.6g} N; error {:+.2e} of {:.4g} N\n", end_of_run.released,
                                 irwin, end_of_run.error(), end_of_run.external);
        EXPECT_LT(end_of_run.released, irwin);
        EXPECT_GT(end_of_run.released, 0.95 * irwin);
        EXPECT_NEAR(end_of_run.error(), 0.0, 0.01 * end_of_run.released);
    }
}

}  // namespace
}  // namespace stria::test
