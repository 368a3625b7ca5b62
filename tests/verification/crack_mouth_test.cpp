// CMOD is the opening where a crack meets the boundary, and the opening behind a tip that at its distance, whoever
// holds the place, zone or structure, and however the crack is listed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/pulled_plate.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

// Pulled so little that flow at the tip changes neither by one in a thousand.
coarse::TipResult barely_flowing_tip(bool plastic, bool contact, bool from_the_tip) {
    Case input = pulled_plate(1.0, plastic, contact);
    input.load.blocks = {{.cycles = 1, .max = 20.0, .min = 0.0}};
    input.load.steps = 4;
    input.fine.enrichment = Enrichment::Topological;
    input.closure.distance = 5.0;
    if (from_the_tip) std::ranges::reverse(input.cracks[0].points);
    return run_direct(input).increments.back().tips.at(0);
}

// Without contact the zone is about the tip alone. CMOD was that where the crack enters the zone, 40 % of it, and the
// opening was empty. With its points listed from the tip a crack had no CMOD.
TEST(CrackMouth, OpensAsMuchWhereZoneOrStructureHoldsIt) {
    for (const bool plastic : {true, false}) {
        const double tolerance = plastic ? 1e-6 : 5e-3;  // without a zone other points integrate the tip functions
        const coarse::TipResult held_by_zone = barely_flowing_tip(plastic, true, false);
        EXPECT_GT(held_by_zone.opening, 0.007);
        EXPECT_GT(held_by_zone.CMOD, held_by_zone.opening);
        for (const bool contact : {true, false})
            for (const bool from_the_tip : {true, false}) {
                const coarse::TipResult tip = barely_flowing_tip(plastic, contact, from_the_tip);
                EXPECT_NEAR(tip.CMOD / held_by_zone.CMOD, 1.0, tolerance) << plastic << contact << from_the_tip;
                EXPECT_NEAR(tip.opening / held_by_zone.opening, 1.0, tolerance) << plastic << contact << from_the_tip;
            }
    }
}

// docs/references.md 2.1. On elements half as large the openings change by 0.4 % at most.
TEST(CrackMouth, OpensAsTheHandbookSaysOfEdgeCracks) {
    constexpr double stated = 0.01, mesh = 0.01;
    for (const double x : {0.1, 0.3, 0.5, 0.7})
        for (const bool flows : {false, true}) {
            Case input = edge_crack(x, 4.0, End::Pulled);
            input.mesh.size = 1.0 / 40.0;
            if (flows) input.material.yield_stress = 300.0;
            input.load.blocks = {{.cycles = 1, .max = 1.0, .min = 0.5}};
            input.load.steps = 2;
            const double c = std::cos(std::numbers::pi * x / 2.0), V = (1.46 + 3.42 * (1.0 - c)) / (c * c);
            const double CMOD = run_direct(input).increments.front().tips.at(0).CMOD;
            EXPECT_NEAR(CMOD * plane_modulus / (4.0 * x * V), 1.0, stated + mesh) << x << flows;
        }
}

}  // namespace
}  // namespace stria::test
