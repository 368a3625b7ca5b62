#include "coarse/growth/tip_break.hpp"

#include <algorithm>

#include "coarse/fracture/turned_tip.hpp"
#include "common/index.hpp"

namespace stria::coarse {

std::vector<double> K_of_break(const Scene& present, GrowthDirection direction, const std::vector<ModesOfTip>& modes) {
    std::vector<double> K;
    for (std::size_t t = 0; t < modes.size(); ++t) {
        const CrackSection& crack = present.input.cracks[at(present.enriched.tips[t].crack)];
        const double turned = direction == GrowthDirection::Straight ? 0.0 : K_at_break(tip_with(modes[t], crack));
        K.push_back(std::max(modes[t].K_I, turned));
    }
    return K;
}

}  // namespace stria::coarse
