// Opening loads of a growing crack over the size of the elements at its tip, at a fixed growth per cycle and at fixed
// distances behind the tip (docs/verification.md, opening loads). The tables are printed.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "common/case/case_file.hpp"
#include "common/index.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/folders.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

const std::vector<double> distances{0.0125, 0.025, 0.05, 0.1, 0.2, 0.4};  // mm; the first is the definition's

/// K_op / K_max in the last cycle of cases/sent-closure, by contact beyond each distance.
std::vector<double> openings(int refine, std::vector<std::string> settings,
                             const std::vector<double>& beyond = distances) {
    settings.insert(settings.end(),
                    {fmt::format("closure.distance={}", beyond[0]),
                     fmt::format("closure.profile=[{}]", fmt::join(beyond.begin() + 1, beyond.end(), ", ")),
                     "fine.beta=2.0", fmt::format("fine.refine={}", refine)});
    const coarse::CycleResult last =
        run_cycles(read_case(std::string(source_folder) + "/cases/sent-closure/case.toml", std::move(settings))).back();
    std::vector<double> found;
    std::cout << fmt::format("elements of {} mm: K_op/K_max", 1.6 / refine);
    for (std::size_t d = 0; d < beyond.size(); ++d) {
        found.push_back(last.contact.at(d).K_op / last.K_max);
        std::cout << fmt::format("  {:.4f} beyond {}", found.back(), beyond[d]);
    }
    std::cout << std::endl;
    return found;
}

/// An independent half model that releases nodes gives 0.490, 0.480 and 0.475 by contact anywhere behind the tip.
void expect_half_model(const std::string& function, const std::array<double, 3>& ours, double within) {
    constexpr std::array half_model{0.490, 0.480, 0.475}, size{0.05, 0.025, 0.0125};
    for (std::size_t k = 0; k < 3; ++k)
        verify({.scene = "opening load, plane stress, R = 0, " + function,
                .source = "independent half model that releases nodes",
                .quantity = "K_op / K_max",
                .reference = half_model[k],
                .ours = ours[k],
                .within = within,
                .mesh = fmt::format("{} mm", size[k]),
                .scale = 1.0});
}

TEST(OpeningLoads, InPlaneStressAreThoseOfAHalfModelAndConvergeLong) {
    const std::vector<std::string> plane{"load.steps=32", "load.grading=1.0", "crack.0.notch=18.0",
                                         "fine.enrichment=single", "fine.substeps=1"};
    const std::vector<double> coarse = openings(32, plane), medium = openings(64, plane), fine = openings(128, plane);
    expect_half_model("one frozen function", {coarse[0], medium[0], fine[0]}, 0.03);
    for (std::size_t d = 1; d < distances.size(); ++d) EXPECT_NEAR(fine[d], medium[d], 0.01) << distances[d];
}

// By default no function stands at the tip. At 0.05 mm, a growth step behind it, the last step's ripple ends.
TEST(OpeningLoads, InPlaneStressAreThoseOfAHalfModelWithoutAFunctionLong) {
    const std::vector<std::string> plane{"load.steps=32", "load.grading=1.0", "crack.0.notch=18.0"};
    const std::vector<double> coarse = openings(32, plane), medium = openings(64, plane), fine = openings(128, plane);
    expect_half_model("no function", {coarse[0], medium[0], fine[0]}, 0.006);
    // Strip yield has the closing and the opening load of first and last contact at K_max / 0.4834 and 0.5567.
    verify({.scene = "opening load, plane stress, R = 0: the trend of strip yield",
            .source = "Budiansky, Hutchinson 1978 (4.3)",
            .quantity = "K_op / K_max between first and last contact",
            .reference = 0.5 * (0.4834 + 0.5567),
            .ours = fine[0],
            .within = 0.1,
            .mesh = "0.0125 mm"});
    for (std::size_t d = 0; d < distances.size(); ++d)
        EXPECT_NEAR(fine[d], medium[d], distances[d] == 0.05 ? 0.035 : 0.015) << distances[d];
}

// Over R the trend of strip yield, which has no strain along the strip and no hardening: K_op rises with R, and the
// part of a cycle in which the crack is closed shrinks, with us to nothing between R = 0.48 and 0.69.
TEST(OpeningLoads, OverTheLoadRatioFollowStripYieldLong) {
    struct At {
        double R, closes, opens;  // closing and opening over K_max: 4.3
    };
    double last = 0.0;
    for (const auto& [R, closes, opens] :
         {At{0.0, 0.4834, 0.5567}, {0.2390, 0.5093, 0.5774}, {0.4838, 0.5951, 0.6465}}) {
        const double ours = openings(32, {"load.steps=32", "load.grading=1.0", "crack.0.notch=18.0",
                                          fmt::format("load.blocks=[{{cycles=30, max=501.0, ratio={}}}]", R)})[0];
        verify({.scene = fmt::format("opening load, plane stress, R = {}: the trend of strip yield", R),
                .source = "Budiansky, Hutchinson 1978 (4.3)",
                .quantity = "K_op / K_max between first and last contact",
                .reference = 0.5 * (closes + opens),
                .ours = ours,
                .within = 0.1,
                .mesh = "0.05 mm",
                .scale = 1.0});
        EXPECT_GT(ours, last);
        EXPECT_GT(ours, R);
        last = ours;
    }
}

// The forward zone on the axis is 0.13 mm, so it takes smaller elements, and fewer cycles. Each step of growth leaves a
// crest where it ends, every 0.05 mm, and the faces part last on the first crest beyond the distance: whether one at
// the distance itself counts is up to half an element. So the distances are half way between crests.
TEST(OpeningLoads, InPlaneStrainConvergeLong) {
    const std::vector<std::string> plane{"model.plane=strain", "load.steps=24", "load.grading=0.8",
                                         "load.blocks.0.cycles=14"};
    const std::vector<double> between{0.0125, 0.025, 0.075, 0.125, 0.175, 0.225, 0.325, 0.425};
    const std::vector<double> medium = openings(128, plane, between), fine = openings(256, plane, between);
    for (std::size_t d = 0; d < between.size(); ++d) EXPECT_NEAR(fine[d], medium[d], 0.01) << between[d];
    EXPECT_GT(fine[0], 0.15);
    EXPECT_LT(fine[0], 0.27);
}

}  // namespace
}  // namespace stria::test
