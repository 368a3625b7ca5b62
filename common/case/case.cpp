#include "common/case/case.hpp"

#include <algorithm>

namespace stria {

bool needs_fine(const Case& scene) {
    const bool contact =
        std::ranges::any_of(scene.cracks, [](const CrackSection& crack) { return crack.contact.has_value(); });
    return scene.material.yield_stress || contact || scene.fine.refine > 1 || scene.fine.radius;
}

bool has_friction(const Case& scene) {
    return std::ranges::any_of(
        scene.cracks, [](const CrackSection& crack) { return crack.contact && crack.contact->friction > 0.0; });
}

}  // namespace stria
