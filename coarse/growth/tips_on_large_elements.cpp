#include "coarse/growth/tips_on_large_elements.hpp"

#include <algorithm>
#include <optional>

#include "coarse/advice/mesh_adequacy.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/growth/growth_texts.hpp"
#include "coarse/zone/tip_refinement.hpp"
#include "common/index.hpp"

namespace stria::coarse {

std::vector<std::string> TipsOnLargeElements::look_at(const Scene& scene, const std::vector<double>& distance) {
    std::vector<std::string> all;
    const std::vector<Tip>& tips = scene.enriched.tips;
    said_.missing.resize(tips.size(), 0);
    said_.by_metal.resize(tips.size(), 0);
    for (std::size_t t = 0; t < tips.size(); ++t) {
        const int tip = static_cast<int>(t), missing = levels_missing(scene, tips[t]);
        if (missing > said_.missing[t]) {
            said_.missing[t] = missing;
            all.push_back(stands_on_large_elements(t, tip_element_edge(scene.enriched, tips[t]), 1 << missing));
        }
        if (const int doubts = doubts_of_metal(scene, t); doubts > said_.by_metal[t]) {
            said_.by_metal[t] = doubts;
            all.push_back(*metal_warning(scene, t));
        }
        if (t >= distance.size() || std::ranges::count(said_.too_near, tip) > 0) continue;
        const std::optional<std::string> warning = distance_warning(scene, t, distance[t]);
        if (!warning) continue;
        said_.too_near.push_back(tip);
        all.push_back(*warning);
    }
    return all;
}

}  // namespace stria::coarse
