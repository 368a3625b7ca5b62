// CMOD is the opening where a crack meets the boundary, and the opening behind a tip that at its distance, whoever
// holds the place, zone or structure, and however the crack is listed.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/pulled_plate.hpp"
#include "tests/support/sent_analysis.hpp"

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

}  // namespace
}  // namespace stria::test
