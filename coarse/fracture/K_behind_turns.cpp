#include "coarse/fracture/K_behind_turns.hpp"

#include <algorithm>
#include <cmath>

#include "coarse/fracture/turned_tip.hpp"

namespace stria::coarse {

std::vector<double> largest_K_behind_turns(const Case& input, const UnitResponse& nominal, double grown) {
    std::vector<double> K = largest_K_I(input, nominal, grown);
    if (!input.growth || input.growth->direction == GrowthDirection::Straight) return K;
    const std::vector<double> any = largest_K(input, nominal, grown);
    for (std::size_t t = 0; t < K.size(); ++t) {
        TipResult tip;
        tip.K_I = K[t];
        tip.K_II = std::sqrt(std::max(any[t] * any[t] - K[t] * K[t], 0.0) / 3.0);  // of largest_K
        const double angle = hoop_stress_angle(tip.K_I, tip.K_II);
        if (std::abs(angle) > sharp_turn) K[t] = K_just_turned(tip, angle);
    }
    return K;
}

std::vector<double> common_K_behind_turns(const Case& input, const UnitResponse& nominal, double grown, int passed) {
    const std::vector<double> usual = common_K_I(input, nominal, grown, passed),
                              largest = largest_K_I(input, nominal, grown);
    std::vector<double> turned = largest_K_behind_turns(input, nominal, grown);
    for (std::size_t t = 0; t < turned.size(); ++t)
        if (usual[t] > 0.0) turned[t] *= usual[t] / largest[t];
    return turned;
}

std::vector<double> K_of_closure(const Case& input, const UnitResponse& nominal) {
    std::vector<double> K = largest_K_behind_turns(input, nominal);
    const std::vector<double> any = largest_K(input, nominal);
    for (std::size_t t = 0; t < K.size(); ++t)
        if (K[t] == 0.0) K[t] = any[t];
    return K;
}

}  // namespace stria::coarse
