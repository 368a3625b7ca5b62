// Increments that an equilibrium remembers, taken over by the next one where cracks have grown in between: what
// predictors start from.
#pragma once

#include <cstdint>
#include <vector>

#include "coarse/equilibrium/equilibrium.hpp"
#include "coarse/structure/structure.hpp"

namespace stria::coarse {

/// Where the next Gamma comes to be: it is this one, or on elements of the core, or on any.
enum class NextGamma : std::uint8_t { Here, InTheCore, Anywhere };

[[nodiscard]] NextGamma gamma_about(const ElementSet& next_zone, const Structure& structure);

class CarriedIncrements {
public:
    /// Of `known`, an equilibrium of `structure`, for the mesh of longer cracks. Where elements were near the structure
    /// tells how the next Gamma moved.
    CarriedIncrements(const Structure& structure, EquilibriumState known, const EnrichedMesh& longer, NextGamma next);

    /// `state`, of an equilibrium of the next structure, which may be on yet another Gamma; with these increments.
    [[nodiscard]] EquilibriumState added_to(EquilibriumState state, const Structure& next) const;

private:
    void find_places(const EnrichedMesh& mesh, const std::vector<int>& wanted, const EnrichedMesh& longer);

    EquilibriumState known_;
    std::vector<int> place_;  // per unknown of the longer cracks' mesh, in displacement_; -1: new, or nobody knows it
    std::vector<Eigen::VectorXd> displacement_;  // per increment, of what next Gammas may ask for, mm
};

}  // namespace stria::coarse
