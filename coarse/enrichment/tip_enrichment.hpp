// Eq. (2): how many functions the tips of a case have, which ones, and how far they reach.
#pragma once

#include <optional>

#include "common/case/case.hpp"

namespace stria::coarse {

/// Which nodes carry tip functions: those of the elements that hold a tip (the paper); those of all elements whose
/// centre lies within a fixed radius, each with unknowns of its own (ill conditioned: kept for comparison); or the same
/// with one pair of unknowns a function, freed from its interpolant (as well conditioned as plain elements).
enum class TipSupport { Topological, Nodal, Gathered };

/// No functions where the elements at all tips are smaller than this part of their crack: an end that is half an
/// element off changes K by a quarter of it.
constexpr double small_elements = 0.02;

struct TipEnrichment {
    int functions = 6;      // the first so many of eq. (2); 0: none, the crack ends on an edge near its tip
    double exponent = 0.5;  // 1/(n+1)
    TipSupport support = TipSupport::Topological;
    std::optional<double> radius = {};  // mm, of fixed-radius supports; absent: as disk_radius() says
    double most_diagonals = 20.0;  // so many diagonals of the tip's element: a larger disk costs more than it gains
    double none_below = 0.0;       // of the crack's length: small_elements, or 0 where functions always stand
};

/// `auto`: within a fixed radius where nothing yields or touches; within two elements around the tip's in an elastic
/// zone, for friction turns errors of the pressure at the tip into errors of K_II; the single function with plasticity,
/// and none where such a crack grows through small elements, or touches and grows by its opening loads (docs/method.md,
/// section 2). Their n is that of a power law where no crack grows, else 1.
TipEnrichment choose_enrichment(const Case& input);

/// Of the nominal body of a case with a zone, which is elastic whatever the zone does: the singular fields of
/// elasticity on the elements about a tip's. Absent where it is the body that is computed anyway.
std::optional<TipEnrichment> enrichment_of_nominal(const Case& input);

}  // namespace stria::coarse
