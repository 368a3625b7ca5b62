// Cracks that grow on behind an overload.
#include <gtest/gtest.h>

#include <algorithm>
#include <fmt/format.h>
#include <iostream>

#include "common/case/schema/case_file.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

/// K_op / K_max of the shipped overload in every cycle, the peak at the end of number `before`.
struct Retardation {
    double before, peak, end;  // K_op / K_max: in front of the overload, behind it at most, and last
    double delay;              // mm from the overload to the peak
};
Retardation retardation(std::vector<std::string> settings, std::size_t before) {
    const Case input = read_case(std::string(test::source_folder) + "/cases/overload/case.toml", std::move(settings));
    std::vector<double> opening;
    for (const coarse::Increment& increment : run_direct(input).increments)
        for (const coarse::CycleResult& cycle : increment.cycles) opening.push_back(cycle.opening.K_op / 300.0);
    const auto overload = opening.begin() + static_cast<std::ptrdiff_t>(before) - 1;
    const auto peak = std::max_element(overload + 1, opening.end());
    const Retardation found{*(overload - 1), *peak, opening.back(),
                            input.growth->increment.value() * static_cast<double>(peak - overload)};
    std::cout << fmt::format("K_op/K_max: {:.3f} before, {:.3f} {:.2f} mm behind the overload, {:.3f} at the end\n",
                             found.before, found.peak, found.delay, found.end);
    return found;
}

// docs/references.md 4.5: delayed retardation. K_op peaks after some growth behind the overload and falls again.
TEST(LoadHistories, AnOverloadRetardsWithDelay) {
    const Retardation found =
        retardation({"fine.refine=16", "growth.increment=0.1", "closure.distance=0.1", "load.steps=12",
                     "load.blocks=[{cycles=4, max=300.0, ratio=0.1}, {cycles=1, max=600.0, min=30.0}, {cycles=9, "
                     "max=300.0, ratio=0.1}]"},
                    4);
    EXPECT_GT(found.peak, found.before + 0.2);
    EXPECT_GE(found.delay, 0.2);
    EXPECT_LT(found.end, found.peak - 0.1);
}

TEST(LoadHistories, AnOverloadRetardsWithDelayLong) {
    const Retardation found = retardation({"load.blocks.0.cycles=10", "load.blocks.2.cycles=26"}, 10);
    EXPECT_GT(found.peak, found.before + 0.2);
    EXPECT_GE(found.delay, 0.2);
    EXPECT_LT(found.end, found.peak - 0.15);
}

}  // namespace
}  // namespace stria::test
