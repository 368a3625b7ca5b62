#include "coarse/specimen/pin_hole.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stria::coarse {

double PinHole::half_edge() const { return 0.5 * std::sqrt(std::numbers::pi) * radius; }

std::array<double, 7> PinHole::lines(int axis) const {
    std::array<double, 7> positions{};
    for (int k = -3; k <= 3; ++k)
        positions[static_cast<std::size_t>(k + 3)] = middle[axis] + half_edge() * std::tan(k * std::numbers::pi / 12.0);
    return positions;
}

bool PinHole::square_holds(const Vec2& x) const { return (x - middle).cwiseAbs().maxCoeff() < half_edge(); }

Vec2 PinHole::moved(const Vec2& x) const {
    const Vec2 arm = x - middle;
    const double distance = arm.norm();
    if (distance >= reach) return x;
    // Where the ray leaves the square.
    const double edge = distance * half_edge() / arm.cwiseAbs().maxCoeff();
    const double left = std::min(1.0, (reach - distance) / (reach - edge));  // 1 on the square, 0 at the reach
    return middle + (1.0 + (radius / edge - 1.0) * left) * arm;
}

}  // namespace stria::coarse
