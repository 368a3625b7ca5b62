#include "common/case/case.hpp"

#include <algorithm>

namespace stria {

bool may_yield(const Case& scene) {
    const auto yields = [](const RegionSection& region) { return region.material.yield_stress.has_value(); };
    return scene.material.yield_stress || std::ranges::any_of(scene.regions, yields);
}

bool has_initial_stress(const Case& scene) {
    const auto misfits = [](const RegionSection& region) { return region.initial_stress.has_value(); };
    return scene.initial_stress || std::ranges::any_of(scene.regions, misfits);
}

bool grows_by_opening_loads(const GrowthSection& growth) {
    return (growth.law == GrowthLaw::Paris || growth.law == GrowthLaw::Table) &&
           growth.driving == GrowthDriving::EffectiveRange;
}

bool grows_by_openings(const GrowthSection& growth) {
    return grows_by_opening_loads(growth) || growth.law == GrowthLaw::Ctod;
}

bool needs_fine(const Case& scene) {
    const bool contact =
        std::ranges::any_of(scene.cracks, [](const CrackSection& crack) { return crack.contact.has_value(); });
    return may_yield(scene) || contact || scene.fine.refine > 1 || scene.fine.radius;
}

int subcells_at_crack(const FineSection& fine) { return fine.subcells.value_or(2); }

int subcells_elsewhere(const FineSection& fine) { return fine.subcells.value_or(fine.refine > 1 ? 1 : 2); }

bool has_friction(const std::vector<CrackSection>& cracks) {
    return std::ranges::any_of(
        cracks, [](const CrackSection& crack) { return crack.contact && crack.contact->friction > 0.0; });
}

}  // namespace stria
