#include "coarse/growth/tips_on_large_elements.hpp"

#include <fmt/format.h>

#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/growth/growth_texts.hpp"
#include "coarse/zone/tip_refinement.hpp"
#include "common/index.hpp"

namespace stria::coarse {

std::vector<std::string> TipsOnLargeElements::look_at(const Scene& scene) {
    std::vector<std::string> all;
    const std::vector<Tip>& tips = scene.enriched.tips;
    known_.resize(tips.size(), 0);
    for (std::size_t t = 0; t < tips.size(); ++t) {
        const int missing = levels_missing(scene, tips[t]);
        if (missing <= known_[t]) continue;
        known_[t] = missing;
        all.push_back(stands_on_large_elements(t, tip_element_edge(scene.enriched, tips[t]), 1 << missing));
    }
    return all;
}

}  // namespace stria::coarse
