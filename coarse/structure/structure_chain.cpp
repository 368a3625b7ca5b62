#include "coarse/structure/structure_chain.hpp"

#include <utility>

namespace stria::coarse {
namespace {

struct Known {
    bool far, middle, behind;
};

// A part serves as long as those that it lies on do.
Known known_of(const StillElements& still, const StructureFactors& factors) {
    const auto serves = [](const auto& part, const ElementSet& elements, const BodyPart* below) {
        return part && part->is_of(elements, below);
    };
    const bool far = serves(factors.far, still.far, nullptr), has_far = far || still.far.none();
    const bool middle = has_far && serves(factors.middle, still.middle, factors.far.get());
    const bool has_middle = middle || (has_far && still.middle.none());
    const BodyPart* below = middle ? factors.middle.get() : factors.far.get();
    return {far, middle, has_middle && serves(factors.behind, still.behind, below)};
}

}  // namespace

std::unique_ptr<Structure> condense(const Scene& scene, const ElementSet& in_zone, const StillElements& still,
                                    StructureFactors& factors, coupling::WorkCounts& work) {
    const Known known = known_of(still, factors);
    auto structure = std::make_unique<Structure>(scene, in_zone, still, std::exchange(factors, {}));
    factors = structure->factors();
    work.structure_elements_assembled += std::ssize(structure->elements().core());
    const auto count = [&](bool serves, const auto& part, const ElementSet& elements, std::int64_t& factorisations) {
        if (serves || !part) return;
        ++factorisations;
        work.structure_elements_assembled += elements.count();
    };
    count(known.far, factors.far, still.far, work.far_factorisations);
    count(known.middle, factors.middle, still.middle, work.middle_factorisations);
    count(known.behind, factors.behind, still.behind, work.behind_factorisations);
    return structure;
}

}  // namespace stria::coarse
