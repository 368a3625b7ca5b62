#include "coarse/growth/room_of_tips.hpp"

#include <algorithm>

#include "coarse/advice/mesh_adequacy.hpp"
#include "common/index.hpp"

namespace stria::coarse {

// The rings are there already: to look for their room once more would cost a pass over the mesh.
std::vector<std::string> RoomOfTips::look_at(const StructureRings& rings) {
    const Scene& scene = rings.elements().scene();
    std::vector<std::string> all;
    for (int tip = 0; tip < std::ssize(scene.enriched.tips); ++tip) {
        if (std::ranges::count(known_, tip) > 0) continue;
        const double radius = std::ranges::max(rings.about(tip).rings(), {}, &Annulus::outer).outer;
        std::optional<std::string> warning = room_warning(scene, at(tip), radius);
        if (!warning) continue;
        known_.push_back(tip);
        all.push_back(std::move(*warning));
    }
    return all;
}

}  // namespace stria::coarse
