// Increments that an equilibrium remembers, taken over by the next one where cracks have grown in between: what
// predictors start from.
#pragma once

#include <vector>

#include "coarse/equilibrium/equilibrium.hpp"
#include "coarse/structure/structure.hpp"

namespace stria::coarse {

class CarriedIncrements {
public:
    /// Of `known`, an equilibrium of `structure`, for the mesh of longer cracks. `gamma_moves`: the next Gamma is
    /// another one. It comes to be where elements were near; there the structure tells how it moved.
    CarriedIncrements(const Structure& structure, EquilibriumState known, const EnrichedMesh& longer, bool gamma_moves);

    /// `state`, of an equilibrium of the next structure, which may be on yet another Gamma; with these increments.
    [[nodiscard]] EquilibriumState added_to(EquilibriumState state, const Structure& next) const;

private:
    EquilibriumState known_;
    std::vector<int> unknown_before_;            // per unknown of the longer cracks' mesh; -1: it is new
    std::vector<Eigen::VectorXd> displacement_;  // per increment, on the mesh before, mm; where nobody knows it, zero
};

}  // namespace stria::coarse
