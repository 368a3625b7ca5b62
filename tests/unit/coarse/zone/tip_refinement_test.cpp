#include "coarse/zone/tip_refinement.hpp"

#include <gtest/gtest.h>

#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "common/fem/centre.hpp"
#include "tests/support/pulled_plate.hpp"
#include "tests/support/refined_squares.hpp"

namespace stria::coarse {
namespace {

Case growing_plate() {
    Case input = test::pulled_plate(1.0, true, true);
    input.fine.refine = 8;
    input.fine.radius = 1.5;
    input.fine.growth = 0.25;
    input.growth = GrowthSection{.increment = 0.1};
    input.load.blocks = {{.cycles = 1, .max = 60.0, .min = 0.0}};
    return input;
}

std::vector<double> K_of(const Scene& scene) { return largest_K(scene.input, unit_response(solve_nominal(scene))); }

TEST(TipRefinement, LeavesTheSceneOfATipAloneUntilItHasComeOn) {
    Case input = growing_plate();
    const Scene scene = refined_scene(input);
    EXPECT_FALSE(asks_for_more(scene.mesh, disks_about_tips(scene, scene.input.cracks, K_of(scene), Room::None), {}));
    bool asked = false;
    for (int step = 1; step <= 10 && !asked; ++step) {
        input.cracks[0].points.back().x() += 0.1;
        asked = asks_for_more(scene.mesh, disks_about_tips(scene, input.cracks, K_of(scene), Room::None), {});
        EXPECT_FALSE(asked && step < 2) << "splits elements at every step";
    }
    EXPECT_TRUE(asked);
}

TEST(TipRefinement, ReachesWhatFlows) {
    const Scene scene = refined_scene(growing_plate());
    const Vec2 tip = scene.enriched.tips[0].position, place = tip + Vec2(3.0, 2.0);
    int flowing = 0;
    for (int e = 0; e < std::ssize(scene.mesh->elements); ++e)
        if ((centre(*scene.mesh, e) - place).norm() < (centre(*scene.mesh, flowing) - place).norm()) flowing = e;
    const ElementSet nothing(scene.mesh->elements.size());
    EXPECT_EQ(disks_about_flow(scene, {flowing}, nothing).at(0).radius, 0.0) << "flow elsewhere";
    ElementSet between = nothing;
    for (int e = 0; e < std::ssize(scene.mesh->elements); ++e)
        if (centre(*scene.mesh, e).y() > tip.y() && (centre(*scene.mesh, e) - tip).norm() < 3.0) between.insert(e);
    const std::vector<RefinedDisk> disks = disks_about_flow(scene, {flowing}, between);
    EXPECT_DOUBLE_EQ(disks.at(0).radius, (centre(*scene.mesh, flowing) - tip).norm());
    const Mesh finer = test::refined(scene.mesh, disks).mesh;
    const auto& n = finer.elements[at(flowing)];
    EXPECT_LE((finer.nodes[at(n[1])] - finer.nodes[at(n[0])]).norm(), 0.25 * disks[0].radius);
}

TEST(TipRefinement, KeepsElementsWholeThatHoldMoreThanJumps) {
    Case input = growing_plate();
    const Scene touching = refined_scene(input);
    input.cracks[0].contact.reset();
    const Scene free = refined_scene(input);
    const ElementSet all_cut = elements_with_more_than_jumps(touching), few = elements_with_more_than_jumps(free);
    const int at_tip = free.enriched.pieces.back().element, at_mouth = free.enriched.pieces.front().element;
    EXPECT_TRUE(few.contains(at_tip));
    EXPECT_FALSE(few.contains(at_mouth));
    EXPECT_TRUE(all_cut.contains(touching.enriched.pieces.front().element));
}

}  // namespace
}  // namespace stria::coarse
