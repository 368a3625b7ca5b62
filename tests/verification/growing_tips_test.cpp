// The faces that a growing plastic crack leaves behind (docs/verification/growth.md, "What stands at a growing tip"):
// without a tip function they are smooth and do not overlap, with the frozen one of each old tip they do.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <iostream>

#include "tests/support/sent_analysis.hpp"
#include "tests/support/turned_mesh.hpp"

namespace stria::test {
namespace {

struct Wake {
    double mean = 0.0;       // opening at the last maximum, mm
    double saw_tooth = 0.0;  // root mean square about the line through the two stations beside each, over the mean
    double overlap = 0.0;    // largest at the last minimum, over the largest opening at the maximum
};

std::vector<coupling::FaceSample> wake_of(const coarse::Increment& increment, double element) {
    std::vector<coupling::FaceSample> wake;
    for (const coupling::FaceSample& sample : increment.zone.faces)
        if (sample.x > 20.0 && sample.x < increment.tips[0].a - element) wake.push_back(sample);
    return wake;
}

/// Of an edge crack in plane stress that grows by an element of 0.2 mm in each of six cycles.
Wake grow(Enrichment enrichment) {
    constexpr double element = 0.2;
    Case input = sent_case(
        {mesh_at_tip(element), "model.plane=stress", "load.steps=20", "load.blocks=[{cycles=6, max=35.0, ratio=0.0}]"});
    input.growth.emplace().increment = element;
    input.fine.enrichment = enrichment;
    const RunHistory run = run_direct(input);
    const coarse::Increment *maximum = nullptr, *minimum = nullptr;
    for (const coarse::Increment& increment : run.increments) {
        if (increment.step.at_maximum) maximum = &increment;
        if (increment.step.at_minimum) minimum = &increment;
    }
    const auto open = wake_of(*maximum, element), closed = wake_of(*minimum, element);
    Wake wake;
    double largest = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < open.size(); ++k) {
        wake.mean += open[k].opening / static_cast<double>(open.size());
        largest = std::max(largest, open[k].opening);
        if (k == 0 || k + 1 == open.size()) continue;
        const auto &before = open[k - 1], &after = open[k + 1];
        const double t = (open[k].s - before.s) / (after.s - before.s);
        const double off = open[k].opening - std::lerp(before.opening, after.opening, t);
        squares += off * off / static_cast<double>(open.size() - 2);
    }
    wake.saw_tooth = std::sqrt(squares) / wake.mean;
    for (const coupling::FaceSample& sample : closed) wake.overlap = std::max(wake.overlap, -sample.opening / largest);
    std::cout << fmt::format("mean opening {:.4g} um, saw-tooth {:.2f} %, overlap {:.2f} %\n", 1e3 * wake.mean,
                             100.0 * wake.saw_tooth, 100.0 * wake.overlap);
    return wake;
}

TEST(GrowingTips, LeaveSmoothFacesWithoutAFunction) {
    const Wake none = grow(Enrichment::Auto), frozen = grow(Enrichment::Single);
    EXPECT_LT(none.saw_tooth, 0.01);
    EXPECT_LT(none.overlap, 0.02);
    EXPECT_GT(frozen.saw_tooth, 2.0 * none.saw_tooth);
    EXPECT_GT(frozen.overlap, 0.02);
}

/// Of the last six of fourteen cycles, each with a growth by an element of 0.2 mm.
std::vector<double> opening_ranges(const Case& input, double degrees) {
    const TemporaryFolder folder;
    std::vector<double> ranges;
    for (const coarse::CycleResult& cycle : run_cycles(on_turned_mesh(input, degrees, folder)))
        ranges.push_back(cycle.opening_range());
    return {ranges.end() - 6, ranges.end()};
}

// Turned lines are crossed at any place and angle. Where the crack cut off a corner its end hardly opened: the range an
// element behind it fell by half in one cycle and was back in the next.
void expect_that_it_opens_alike(const std::string& plane, std::initializer_list<double> angles) {
    Case input = sent_case({"mesh.grading=[]", "mesh.size=1.6", "fine.refine=8", "model.plane=" + plane,
                            "load.steps=16", "load.blocks=[{cycles=14, max=35.0, ratio=0.0}]", "growth.increment=0.2",
                            "growth.direction=straight", "closure.distance=0.2"});
    const std::vector<double> along = opening_ranges(input, 0.0);
    for (const double degrees : angles) {
        const std::vector<double> across = opening_ranges(input, degrees);
        for (std::size_t k = 0; k < along.size(); ++k) {
            std::cout << fmt::format("{} {} {:.3f}\n", plane, degrees, across[k] / along[k]);
            EXPECT_NEAR(across[k] / along[k], 0.95, 0.1) << plane << " " << degrees;
        }
    }
}

TEST(GrowingTips, OpenAlikeAtAnyAngleLong) {
    expect_that_it_opens_alike("stress", {20.0, 30.0});
    expect_that_it_opens_alike("strain", {20.0, 30.0});
}

}  // namespace
}  // namespace stria::test
