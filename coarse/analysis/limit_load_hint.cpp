#include "coarse/analysis/limit_load_hint.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace stria::coarse {

// No equilibrium of a body that bears its load moves a boundary by a tenth of the body.
std::string limit_load_hint(const Scene& scene, double moved) {
    const bool may_have = scene.materials.may_yield() && !scene.unit_force.isZero(0.0);
    if (!may_have || scene.input.load.control != Control::Load) return "";
    constexpr auto remedy = "load.control = \"displacement\" goes past its limit load";
    const auto [left, right] = std::ranges::minmax(scene.mesh.nodes, {}, [](const Vec2& x) { return x.x(); });
    if (moved < 0.1 * (right.x() - left.x())) return fmt::format("; if the body bears no more, {}", remedy);
    return fmt::format("; the body bears no more, its loaded boundary has moved by {:.3g} mm: {}", moved, remedy);
}

}  // namespace stria::coarse
