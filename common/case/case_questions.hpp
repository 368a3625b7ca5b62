// What is asked of a case again and again: answers that follow from several of its keys, given once.
#pragma once

#include <algorithm>
#include <vector>

#include "common/case/case.hpp"

namespace stria {

/// Some material has a yield stress.
inline bool may_yield(const Case& scene) {
    const auto yields = [](const RegionSection& region) { return region.material.yield_stress.has_value(); };
    return scene.material.yield_stress || std::ranges::any_of(scene.regions, yields);
}

/// There is stress before any load.
inline bool has_initial_stress(const Case& scene) {
    const auto misfits = [](const RegionSection& region) { return region.initial_stress.has_value(); };
    return scene.initial_stress || std::ranges::any_of(scene.regions, misfits);
}

/// Faces of the crack are kept from overlapping, in front of its notch. Those of others are free of traction.
inline bool may_touch(const CrackSection& crack) { return crack.contact.has_value(); }
inline bool some_touch(const std::vector<CrackSection>& cracks) { return std::ranges::any_of(cracks, may_touch); }

/// Some faces have friction.
inline bool has_friction(const std::vector<CrackSection>& cracks) {
    return std::ranges::any_of(
        cracks, [](const CrackSection& crack) { return crack.contact && crack.contact->friction > 0.0; });
}

/// The increment of growth is given, and no law of da/dN.
inline bool is_prescribed(const GrowthSection& growth) { return growth.law == GrowthLaw::Prescribed; }

/// da/dN follows from a range of K.
inline bool is_law_of_dK(const GrowthSection& growth) {
    return growth.law == GrowthLaw::Paris || growth.law == GrowthLaw::Table;
}

/// Opening loads decide a life: they drive a law of dK.
inline bool grows_by_opening_loads(const GrowthSection& growth) {
    return is_law_of_dK(growth) && growth.driving == GrowthDriving::EffectiveRange;
}

/// What becomes of the faces behind a tip decides a life: its opening load, or how far its faces open.
inline bool grows_by_openings(const GrowthSection& growth) {
    return grows_by_opening_loads(growth) || growth.law == GrowthLaw::Ctod;
}

/// The load at which the metal ahead of a tip comes under tension is looked for.
inline bool measures_tension(const ClosureSection& closure) {
    return closure.tension || closure.definition == OpeningDefinition::Tension;
}

/// The fine component starts if, and only if, there is a yield stress, contact or refinement, or a force ahead of a tip
/// to measure: its points tell it.
inline bool needs_fine(const Case& scene) {
    const bool looks_ahead = measures_tension(scene.closure) && !scene.cracks.empty();
    return may_yield(scene) || some_touch(scene.cracks) || scene.fine.refine > 1 || scene.fine.radius || looks_ahead;
}

/// Sub-quadrangles per element edge in a zone: where a crack is or goes straight on, and away from both. A refined zone
/// has elements as small as sub-quadrangles are meant to be.
inline int subcells_at_crack(const FineSection& fine) { return fine.subcells.value_or(2); }
inline int subcells_elsewhere(const FineSection& fine) { return fine.subcells.value_or(fine.refine > 1 ? 1 : 2); }

}  // namespace stria
