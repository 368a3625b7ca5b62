#include "coarse/zone/zone_refinement.hpp"

#include <algorithm>
#include <bit>

#include "coarse/analysis/growth_law.hpp"
#include "coarse/fracture/load_scale.hpp"
#include "coarse/model/tip_reach.hpp"
#include "coarse/zone/zone_selection.hpp"

namespace stria::coarse {

std::vector<RefinedDisk> disks_to_refine(const Scene& scene) {
    const EnrichedMesh& mesh = scene.enriched;
    const FineSection& fine = scene.input.fine;
    const double way = scene.input.growth ? planned_growth(*scene.input.growth, scene.input.load) : 0.0;
    std::vector<double> K_I(mesh.tips.size(), 0.0);
    if (!fine.radius) {
        const Structure elastic(scene, std::vector<char>(mesh.elements.size(), 0));
        const std::vector<TipResult> tips = fracture_parameters(elastic, elastic.expand({}, 1.0), {});
        const double largest = largest_load_factor(scene.input.load, elastic, tips, way);
        std::ranges::transform(tips, K_I.begin(), [&](const TipResult& tip) { return largest * tip.K_I; });
    }
    std::vector<RefinedDisk> disks;
    for (std::size_t t = 0; t < mesh.tips.size(); ++t) {
        const double smallest = tip_element_size(mesh, mesh.tips[t]) / fine.refine;
        const Tip& tip = mesh.tips[t];
        disks.push_back({tip.position, tip.position + way * tip.direction,
                         std::max(zone_radius(scene.input, K_I[t]), 3.0 * smallest),
                         std::countr_zero(static_cast<unsigned>(fine.refine)), fine.growth});
    }
    return disks;
}

}  // namespace stria::coarse
