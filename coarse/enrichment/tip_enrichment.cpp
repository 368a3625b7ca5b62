#include "coarse/enrichment/tip_enrichment.hpp"

#include "common/case/case_questions.hpp"

namespace stria::coarse {
namespace {

/// n of the strain's r^(-n/(n+1)) at the tip. Behind a growing tip the metal has unloaded: there it is no power law's.
double singular_n(const Case& input) {
    const MaterialSection& metal = input.material;
    const bool of_power_law =
        metal.yield_stress && metal.isotropic.law == HardeningLaw::Power && metal.kinematic.empty();
    return input.fine.enrichment_n.value_or(of_power_law && !input.growth ? metal.isotropic.n : 1.0);
}

}  // namespace

TipEnrichment choose_enrichment(const Case& input) {
    const FineSection& fine = input.fine;
    const double exponent = 1.0 / (singular_n(input) + 1.0);
    const TipEnrichment none{.functions = 0, .exponent = 0.5};
    const TipEnrichment single{.functions = 1, .exponent = exponent}, topological{.functions = 6, .exponent = exponent};
    const TipEnrichment growing{.functions = 1, .exponent = exponent, .none_below = small_elements};
    // Four of the six span the singular fields of elasticity.
    const TipEnrichment geometrical{
        .functions = 4, .exponent = 0.5, .support = TipSupport::Gathered, .radius = fine.enrichment_radius};
    const TipEnrichment in_zone{.functions = 4, .exponent = 0.5, .support = TipSupport::Nodal, .most_diagonals = 1.6};
    switch (fine.enrichment) {
    case Enrichment::None:
        return none;
    case Enrichment::Single:
        return single;
    case Enrichment::Topological:
        return topological;
    case Enrichment::Geometrical:
        return geometrical;
    case Enrichment::Auto:
        break;
    }
    if (!may_yield(input)) return needs_fine(input) ? in_zone : geometrical;  // what a tip leaves is forgotten
    if (!input.growth) return single;
    // What a function leaves on the faces moves opening loads, and a life by these is off by several times as much.
    return some_touch(input.cracks) && grows_by_opening_loads(*input.growth) ? none : growing;
}

std::optional<TipEnrichment> enrichment_of_nominal(const Case& input) {
    if (!needs_fine(input)) return std::nullopt;
    // The elements about the tip's reach as far. Larger disks cost more in each growth and moved K by 1e-4.
    return TipEnrichment{.functions = 4, .exponent = 0.5, .support = TipSupport::Gathered, .most_diagonals = 1.2};
}

}  // namespace stria::coarse
