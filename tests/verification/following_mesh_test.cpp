// Small elements that follow the tips of growing cracks, against meshes that were small along the whole way from the
// start.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iostream>
#include <limits>

#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/specimen/specimen.hpp"
#include "coarse/zone/tip_refinement.hpp"
#include "common/geometry/segment.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

struct Grown {
    std::vector<coarse::CycleResult> cycles;
    std::vector<coarse::TipResult> nominal;
    std::vector<Vec2> crack;
    std::size_t elements = 0;
    double at_tip = 0.0;  // diagonal of the tip's element, mm
    int splits = 0;
};

Grown grow_on(const Case& input, const coarse::Scene& scene) {
    use_one_thread();
    fine::FineModel fine(input);
    coarse::CondensedFactory factory(&fine, input);
    Grown grown;
    coarse::Listener listener;
    listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure& structure) {
        grown.cycles.insert(grown.cycles.end(), increment.cycles.begin(), increment.cycles.end());
        grown.elements = structure.scene().mesh->elements.size();
        grown.at_tip = coarse::tip_element_size(structure.scene().enriched, structure.scene().enriched.tips[0]);
        grown.crack = structure.scene().input.cracks[0].points;
    };
    coarse::FatigueAnalysis analysis(scene, factory, listener);
    analysis.run();
    grown.nominal = analysis.nominal();
    grown.splits = analysis.effort().counts.mesh_splits;
    return grown;
}

/// Wakes of a few steps, opening loads by contact 0.5 mm behind the tip.
Case growing(double increment, int cycles, const std::string& plane) {
    return sent_case({"mesh.grading=[]", "mesh.size=2.0", "fine.refine=8", "model.plane=" + plane,
                      fmt::format("load.blocks=[{{cycles={}, max=45.0, ratio=0.0}}]", cycles), "load.steps=16",
                      "load.grading=0.6", fmt::format("growth.increment={}", increment), "closure.distance=0.5"});
}

class FollowingMesh : public testing::TestWithParam<const char*> {};

TEST_P(FollowingMesh, GivesWhatAMeshThatIsSmallAlongTheWayGives) {
    const Case input = growing(0.25, 6, GetParam());
    const Grown following = grow_on(input, coarse::refined_scene(input));
    const Grown planned = grow_on(input, refined_along(input, {20.0, 100.0}, {30.0, 100.0}, 3.2));
    const coarse::CycleResult &own = following.cycles.back(), &other = planned.cycles.back();
    std::cout << fmt::format(
        "{:7} {} elements after {} splits, {} planned; K_op/K_max {:.4f} and {:.4f}, opening range "
        "{:.6e} and {:.6e}, J {:.5f} and {:.5f}\n",
        GetParam(), following.elements, following.splits, planned.elements, own.opening.K_op / own.K_max,
        other.opening.K_op / other.K_max, own.opening_range(), other.opening_range(), own.J_max, other.J_max);
    EXPECT_GE(following.splits, 2);
    EXPECT_NEAR(following.at_tip, planned.at_tip, 1e-9);
    EXPECT_EQ(planned.splits, 0);
    EXPECT_GE(other.opening.K_op, 0.0);
    EXPECT_NEAR(own.opening.K_op / own.K_max, other.opening.K_op / other.K_max, 0.002);
    EXPECT_NEAR(own.opening_range() / other.opening_range(), 1.0, 1e-3);
    EXPECT_NEAR(own.J_max / other.J_max, 1.0, 1e-3);
    EXPECT_NEAR(own.K_max / other.K_max, 1.0, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Plane, FollowingMesh, testing::Values("stress", "strain"),
                         [](const auto& plane) { return std::string(plane.param); });

// A kink of 45 degrees turns back across the load, out of any strip along its first direction.
TEST(FollowingMeshOfAKinkedCrack, GoesWhereAMeshThatIsSmallEverywhereGoesLong) {
    Case input = growing(0.25, 12, "stress");
    input.cracks[0].points = {{0.0, 98.3}, {15.1, 98.3}, {17.1, 100.3}};
    const Grown following = grow_on(input, coarse::refined_scene(input));
    const Grown everywhere = grow_on(input, refined_along(input, {15.0, 98.3}, {22.0, 101.0}, 4.0));
    double off = (following.crack.back() - everywhere.crack.back()).norm();
    for (const Vec2& point : following.crack) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k + 1 < everywhere.crack.size(); ++k)
            nearest = std::min(nearest, distance_to_segment(point, everywhere.crack[k], everywhere.crack[k + 1]));
        off = std::max(off, nearest);
    }
    const coarse::CycleResult &own = following.cycles.back(), &other = everywhere.cycles.back();
    std::cout << fmt::format("{} elements after {} splits, {} everywhere; path off by {:.2e} mm, K {:.4f} and {:.4f}, "
                             "K_op/K_max {:.4f} and {:.4f}\n",
                             following.elements, following.splits, everywhere.elements, off, own.K_max, other.K_max,
                             own.opening.K_op / own.K_max, other.opening.K_op / other.K_max);
    EXPECT_GE(following.splits, 3);
    EXPECT_NEAR(following.at_tip, everywhere.at_tip, 1e-9);
    EXPECT_LT(off, 0.02);
    EXPECT_NEAR(own.K_max / other.K_max, 1.0, 0.005);
    EXPECT_NEAR(own.opening.K_op / own.K_max, other.opening.K_op / other.K_max, 0.01);
}

}  // namespace
}  // namespace stria::test
