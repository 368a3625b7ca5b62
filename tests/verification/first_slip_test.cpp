// The load at which a tip slides first, where faces slide and part or stick again within one increment.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "common/case/schema/case_file.hpp"
#include "tests/support/folders.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

/// Of the rough crack, per distance behind its tip, in its one cycle.
std::vector<double> first_slips(int steps, bool swapped, double& range) {
    Case input = read_case(std::string(source_folder) + "/tests/data/cases/first-slip.toml",
                           {fmt::format("load.steps={}", steps)});
    if (swapped) std::swap(input.cracks[0], input.cracks[1]);
    const coarse::CycleResult cycle = run_direct(input).increments.back().cycles.at(swapped ? 0 : 1);
    range = cycle.K_max - cycle.K_min;
    return cycle.K_slip;
}

// The order of the cracks decides where contact is looked for first, and so what is seen of slip by chance.
TEST(FirstSlip, DoesNotDependOnWhereElseIsLooked) {
    for (const int steps : {8, 12}) {
        double range = 0.0;
        const std::vector<double> K = first_slips(steps, false, range), swapped = first_slips(steps, true, range);
        ASSERT_EQ(K.size(), 3U);
        for (std::size_t d = 0; d < K.size(); ++d) {
            std::cout << fmt::format("{} increments: K_slip {:.2f} and {:.2f} of {:.0f}\n", steps, K[d], swapped[d],
                                     range);
            EXPECT_NEAR(K[d], swapped[d], 0.002 * range);
        }
    }
}

}  // namespace
}  // namespace stria::test
