#include "coarse/analysis/crack_growth.hpp"

#include <gtest/gtest.h>

#include "coarse/zone/refined_scene.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::coarse {
namespace {

// At the minimum a crack grows between the two extremes of its cycle. What its tip would be driven by behind a turn is
// of one length, the longer one; and so is K_II, but what friction let through at the minimum nobody has asked again.
TEST(CrackGrowth, AtTheMinimumACycleIsOfTheLongerCrack) {
    for (const double friction : {0.0, 0.3}) {
        Case input = test::sent_case({"mesh.width=24.0", "mesh.size=2.0", "mesh.grading=[]", "fine.refine=1"});
        input.cracks.front().points = {{0.0, 0.5 * input.mesh.height + 0.2}, {8.0, 0.5 * input.mesh.height + 0.2}};
        input.cracks.front().contact = ContactSection{.friction = friction};
        input.growth =
            GrowthSection{.law = GrowthLaw::Paris, .increment = 0.5, .at = GrowthAt::Minimum, .C = 1e-12, .m = 3.0};
        const Scene scene = refined_scene(input);
        const Note note = [](const std::string&) {};
        CrackGrowth growth(input, note);
        Increment reached;
        reached.tips.resize(1);
        reached.step.at_minimum = true;
        reached.load_factor = 10.0;
        reached.nominal = {{.K_I = 2.0, .K_II = 1.0}};
        growth.take(reached, scene);
        reached.step = {};
        reached.step.ends_cycle = reached.step.at_maximum = true;
        reached.load_factor = 20.0;
        reached.nominal = {{.K_I = 3.0, .K_II = 1.5}};
        growth.take(reached, scene);
        const std::vector<ModesOfTip> cycle = growth.memory().turning.cycles;
        ASSERT_EQ(cycle.size(), 2U);
        EXPECT_EQ(cycle[0], (ModesOfTip{60.0, 30.0}));
        EXPECT_EQ(cycle[1], (ModesOfTip{30.0, friction > 0.0 ? 10.0 : 15.0}));
    }
}

}  // namespace
}  // namespace stria::coarse
