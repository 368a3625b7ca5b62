#include "coarse/zone/refined_scene.hpp"

#include <algorithm>
#include <bit>

#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/load/growth_schedule.hpp"
#include "coarse/model/crack_room.hpp"
#include "coarse/model/mesh_refinement.hpp"
#include "coarse/model/tip_reach.hpp"
#include "coarse/specimen/specimen.hpp"
#include "coarse/zone/zone_selection.hpp"

namespace stria::coarse {
namespace {

/// `K_I`: the largest of the load history, one per tip. `way`: planned growth, mm.
std::vector<RefinedDisk> disks_about_tips(const Scene& unrefined, const std::vector<double>& K_I, double way) {
    const EnrichedMesh& mesh = unrefined.enriched;
    const FineSection& fine = unrefined.input.fine;
    std::vector<RefinedDisk> disks;
    for (std::size_t t = 0; t < mesh.tips.size(); ++t) {
        const Tip& tip = mesh.tips[t];
        const double smallest = tip_element_size(mesh, tip) / fine.refine;
        disks.push_back({tip.position, tip.position + way * tip.direction,
                         std::max(zone_radius(fine, unrefined.yield_stress_at_tips()[t], K_I[t]), 3.0 * smallest),
                         std::countr_zero(static_cast<unsigned>(fine.refine)), fine.growth});
    }
    return disks;
}

}  // namespace

Scene refined_scene(const Case& input) {
    Scene scene = make_scene(input, make_mesh(input.mesh, input.cracks, input.regions));
    require_room(scene.mesh, scene.enriched, input.fine.refine);
    if (input.fine.refine == 1) return scene;
    const double way = input.growth ? planned_growth(*input.growth, input.load) : 0.0;
    std::vector<double> K_I(scene.enriched.tips.size(), 0.0);
    if (!input.fine.radius) K_I = largest_K_I(input.load, unit_response(solve_nominal(scene)), way);
    return make_scene(input, refine(scene.mesh, disks_about_tips(scene, K_I, way)));
}

}  // namespace stria::coarse
