#include "coarse/equilibrium/condensed/gamma_supports.hpp"

#include <algorithm>

namespace stria::coarse {

GammaSupports::GammaSupports(const Structure& structure) : structure_(structure) {
    const Scene& scene = structure.scene();
    for (std::size_t k = 0; k < scene.prescribed.size(); ++k) {
        const PrescribedUnknown& prescribed = scene.prescribed[k];
        const auto found = std::ranges::lower_bound(structure.gamma(), prescribed.unknown);
        if (found == structure.gamma().end() || *found != prescribed.unknown) continue;
        held_.push_back({found - structure.gamma().begin(), &prescribed, scene.pull[static_cast<Eigen::Index>(k)]});
    }
}

void GammaSupports::impose(GammaState& state) const {
    for (const Held& held : held_) state.displacement[held.place] = held.prescribed->under(state.factors());
}

void GammaSupports::add_pull(const CondensedTangent& zone, Eigen::VectorXd& force) const {
    for (const Held& held : held_)
        if (const double value = held.prescribed->value; value != 0.0)
            force -= value * structure_.on_free_places(zone.column(held.place));
}

void GammaSupports::add_reactions(const Eigen::VectorXd& zone_force, MachineReading& reading) const {
    for (const auto& [place, prescribed, share] : held_) {
        reading.force += share * zone_force[place];
        reading.imposed_force += prescribed->value * zone_force[place];
        for (Eigen::Index k = 0; k < std::ssize(prescribed->in_cases); ++k)
            reading.imposed_forces_of_cases[k] += prescribed->in_case(k) * zone_force[place];
    }
}

}  // namespace stria::coarse
