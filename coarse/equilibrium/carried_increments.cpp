#include "coarse/equilibrium/carried_increments.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "common/index.hpp"

namespace stria::coarse {

NextGamma gamma_about(const ElementSet& next_zone, const Structure& structure) {
    if (next_zone == structure.in_zone()) return NextGamma::Here;
    const auto is_outside = [&](int element) { return structure.is_in_middle(element) || structure.is_far(element); };
    return std::ranges::any_of(next_zone.members(), is_outside) ? NextGamma::Anywhere : NextGamma::InTheCore;
}

CarriedIncrements::CarriedIncrements(const Structure& structure, EquilibriumState known, const EnrichedMesh& longer,
                                     NextGamma next)
    : known_(std::move(known)) {
    const EnrichedMesh& mesh = structure.scene().enriched;
    std::vector<int> wanted = structure.gamma();
    if (next != NextGamma::Here) {
        const std::span<const int> more =
            next == NextGamma::InTheCore ? structure.core_unknowns() : structure.near_unknowns();
        wanted.insert(wanted.end(), more.begin(), more.end());
    }
    find_places(mesh, wanted, longer);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.unknowns);
    for (std::size_t k = 0; k < known_.increments.size(); ++k) {
        if (next == NextGamma::InTheCore)
            structure.expand_core(known_.increments[k], known_.load_increments[k], 0.0, u);
        if (next == NextGamma::Anywhere) structure.expand_near(known_.increments[k], known_.load_increments[k], 0.0, u);
        u(structure.gamma()) = known_.increments[k];
        displacement_.push_back(gather(u, wanted));
    }
}

void CarriedIncrements::find_places(const EnrichedMesh& mesh, const std::vector<int>& wanted,
                                    const EnrichedMesh& longer) {
    std::vector<int> place(at(mesh.unknowns), -1);
    for (std::size_t k = 0; k < wanted.size(); ++k) place[at(wanted[k])] = static_cast<int>(k);
    place_ = same_unknowns(longer, mesh);
    for (int& unknown : place_)
        if (unknown >= 0) unknown = place[at(unknown)];
}

EquilibriumState CarriedIncrements::added_to(EquilibriumState state, const Structure& next) const {
    state.increments.clear();
    state.whole_increments.clear();
    for (const Eigen::VectorXd& u : displacement_) {
        Eigen::VectorXd& on_gamma = state.increments.emplace_back(Eigen::VectorXd::Zero(std::ssize(next.gamma())));
        for (std::size_t k = 0; k < next.gamma().size(); ++k) {
            const int place = place_[at(next.gamma()[k])];
            if (place >= 0) on_gamma[static_cast<Eigen::Index>(k)] = u[place];
        }
    }
    state.load_increments = known_.load_increments;
    return state;
}

}  // namespace stria::coarse
