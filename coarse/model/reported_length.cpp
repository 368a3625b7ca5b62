#include "coarse/model/reported_length.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "coarse/enrichment/crack_length.hpp"
#include "coarse/load/growth_schedule.hpp"
#include "common/crack/crack_end.hpp"
#include "common/error.hpp"
#include "common/geometry/segment.hpp"
#include "common/index.hpp"

namespace stria::coarse {

double reported_length(const Scene& scene, const Tip& tip) {
    if (scene.mesh->load_line) return tip.position.x() - *scene.mesh->load_line;
    const auto tips = std::ranges::count(scene.enriched.tips, tip.crack, &Tip::crack);
    return length_in_body(scene.enriched, tip.crack) / static_cast<double>(tips);
}

// What moves a tip onto a node is a part of its way, as it is of a.
double way_to_tip(const Scene& scene, const Tip& tip) {
    const CrackSection& crack = scene.input.cracks[at(tip.crack)];
    const Vec2 end = end_of(crack, tip), before = end - last_stretch(crack, tip);
    const double moved = (tip.position - before).norm() - (end - before).norm();
    return (tip.upper > 0 ? length_of(crack.points) - crack.grown_at_start : crack.grown_at_start) + moved;
}

void require_way_to_grow(const Scene& scene) {
    if (!scene.input.growth) return;
    const std::vector<Tip>& tips = scene.enriched.tips;
    for (std::size_t t = 0; t < tips.size(); ++t) {
        const double a = reported_length(scene, tips[t]);
        if (is_as_long_as_asked(*scene.input.growth, a))
            throw CaseError(fmt::format("growth.until = {:g}: tip {} has a = {:.6g} mm before it grows, so nothing "
                                        "would",
                                        *scene.input.growth->until, t, a));
    }
}

}  // namespace stria::coarse
