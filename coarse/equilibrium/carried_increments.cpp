#include "coarse/equilibrium/carried_increments.hpp"

#include <utility>

#include "common/index.hpp"

namespace stria::coarse {

CarriedIncrements::CarriedIncrements(const Structure& structure, EquilibriumState known, const EnrichedMesh& longer,
                                     bool gamma_moves)
    : known_(std::move(known)) {
    const EnrichedMesh& mesh = structure.scene().enriched;
    const Eigen::VectorXd numbers = Eigen::VectorXd::LinSpaced(mesh.unknowns, 0.0, mesh.unknowns - 1.0);
    for (const double number : carry_over(mesh, numbers, longer, Eigen::VectorXd::Constant(longer.unknowns, -1.0)))
        unknown_before_.push_back(static_cast<int>(number));
    for (std::size_t k = 0; k < known_.increments.size(); ++k) {
        Eigen::VectorXd& u = displacement_.emplace_back(Eigen::VectorXd::Zero(mesh.unknowns));
        if (gamma_moves) structure.expand_near(known_.increments[k], known_.load_increments[k], 0.0, u);
        u(structure.gamma()) = known_.increments[k];
    }
}

EquilibriumState CarriedIncrements::added_to(EquilibriumState state, const Structure& next) const {
    state.increments.clear();
    state.whole_increments.clear();
    for (const Eigen::VectorXd& u : displacement_) {
        Eigen::VectorXd& on_gamma = state.increments.emplace_back(Eigen::VectorXd::Zero(std::ssize(next.gamma())));
        for (std::size_t k = 0; k < next.gamma().size(); ++k) {
            const int before = unknown_before_[at(next.gamma()[k])];
            if (before >= 0) on_gamma[static_cast<Eigen::Index>(k)] = u[before];
        }
    }
    state.load_increments = known_.load_increments;
    return state;
}

}  // namespace stria::coarse
