#include "coarse/zone/refined_scene.hpp"

#include <utility>

#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/specimen/specimen.hpp"
#include "coarse/zone/tip_refinement.hpp"

namespace stria::coarse {

Scene refined_scene(const Case& input, const std::function<void(const Scene&)>& before_solving) {
    Scene scene =
        make_scene(input, make_mesh(input.mesh, input.cracks, input.regions, input.boundaries), input.fine.refine);
    if (input.fine.refine == 1) return scene;
    std::vector<double> K(scene.enriched.tips.size(), 0.0);
    if (!input.fine.radius || input.growth) {
        if (before_solving) before_solving(scene);
        K = largest_K(input.load, unit_response(solve_nominal(scene)), 0.0, CaseHistories(input));
    }
    Mesh refined = refine(scene.mesh, disks_about_tips(scene, input.cracks, K, Room::ToGrow)).mesh;
    refined.material.clear();  // small elements tell the outlines of regions better
    return make_scene(input, std::move(refined));
}

}  // namespace stria::coarse
