#include "coarse/equilibrium/condensed/expanded_displacement.hpp"

#include <utility>

#include "coarse/structure/proportion.hpp"

namespace stria::coarse {

const Eigen::VectorXd& ExpandedDisplacement::whole(const GammaState& state) const {
    if (!whole_) {
        whole_ = structure_.expand(state.displacement, state.factors(), 1.0);
        ++work_.structure_solves_full;
    }
    return *whole_;
}

const Eigen::VectorXd& ExpandedDisplacement::near(const GammaState& state) const {
    if (near_known_) return near_;
    if (answers_in_proportion(structure_)) {
        near_ = state.load_factor * structure_.near_of_unit_load(work_.structure_solves_near);
    } else {
        structure_.expand_near(state.displacement, state.factors(), 1.0, near_);
        ++work_.structure_solves_near;
    }
    near_known_ = true;
    return near_;
}

DisplacementBesideFar ExpandedDisplacement::beside_far(const GammaState& state) const {
    Eigen::VectorXd u = near(state);
    auto far = structure_.beside_near(state.factors(), 1.0, u);
    return {std::move(u), std::move(far)};
}

}  // namespace stria::coarse
