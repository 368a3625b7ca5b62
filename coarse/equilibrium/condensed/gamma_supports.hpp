// Places on Gamma that are held or moved: the zone pulls at them, and the structure has no unknowns there.
#pragma once

#include <vector>

#include "coarse/equilibrium/condensed/gamma_states.hpp"
#include "coarse/equilibrium/equilibrium.hpp"
#include "coarse/structure/structure.hpp"

namespace stria::coarse {

class GammaSupports {
public:
    explicit GammaSupports(const Structure& structure);

    [[nodiscard]] bool empty() const { return held_.empty(); }

    /// Moves them as the state's load factors say.
    void impose(GammaState& state) const;

    /// Force on the free places, N/mm, that moving them by a load factor of 1 makes by way of the zone.
    void add_pull(const CondensedTangent& zone, Eigen::VectorXd& force) const;

    /// What a machine reads of the reactions to the zone's force on Gamma, N/mm.
    void add_reactions(const Eigen::VectorXd& zone_force, MachineReading& reading) const;

private:
    struct Held {
        Eigen::Index place;
        const PrescribedUnknown* prescribed;
        double share;  // of its reaction in the machine's force
    };

    const Structure& structure_;
    std::vector<Held> held_;
};

}  // namespace stria::coarse
