// The faces that a growing plastic crack leaves behind (docs/verification.md, "What stands at a growing tip"): without
// a tip function they are smooth and do not overlap, with the frozen one of each old tip they do.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <iostream>

#include "tests/support/sent_analysis.hpp"

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

}  // namespace
}  // namespace stria::test
