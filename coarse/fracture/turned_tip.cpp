#include "coarse/fracture/turned_tip.hpp"

#include <algorithm>
#include <cmath>

namespace stria::coarse {

double hoop_stress_angle(double K_I, double K_II) {
    if (std::abs(K_II) <= 0.005 * std::max(-K_I, 0.0)) return 0.0;  // closed, or no field at all: no direction
    K_I = std::max(K_I, 0.0);
    return -2.0 * std::atan2(2.0 * K_II, K_I + std::hypot(K_I, std::sqrt(8.0) * K_II));
}

double K_just_turned(const TipResult& before, double angle) {
    const double c = std::cos(0.5 * angle), s = std::sin(0.5 * angle);
    return c * c * (c * before.K_I - 3.0 * s * before.K_II);
}

double K_at_break(const TipResult& tip) {
    const double angle = hoop_stress_angle(tip.K_I, tip.K_II);
    return std::abs(angle) > sharp_turn ? std::max(tip.K_I, K_just_turned(tip, angle)) : tip.K_I;
}

}  // namespace stria::coarse
