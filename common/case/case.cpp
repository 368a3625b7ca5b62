#include "common/case/case.hpp"

#include <algorithm>

namespace stria {

bool needs_fine(const Case& scene) { return needs_fine(scene.fine, scene.material, scene.cracks); }

bool needs_fine(const FineSection& fine, const MaterialSection& material, const std::vector<CrackSection>& cracks) {
    const bool contact =
        std::ranges::any_of(cracks, [](const CrackSection& crack) { return crack.contact.has_value(); });
    return material.yield_stress || contact || fine.refine > 1 || fine.radius;
}

int subcells_at_crack(const FineSection& fine) { return fine.subcells.value_or(2); }

int subcells_elsewhere(const FineSection& fine) { return fine.subcells.value_or(fine.refine > 1 ? 1 : 2); }

double contact_begins(const CrackSection& crack) {
    return crack.notch > 0.0 ? crack.notch : -std::numeric_limits<double>::infinity();
}

bool has_friction(const std::vector<CrackSection>& cracks) {
    return std::ranges::any_of(
        cracks, [](const CrackSection& crack) { return crack.contact && crack.contact->friction > 0.0; });
}

}  // namespace stria
