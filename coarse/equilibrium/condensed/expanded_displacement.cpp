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
        if (!near_of_unit_load_) find_near({{}, 1.0}, near_of_unit_load_.emplace(near_));
        near_ = state.load_factor * *near_of_unit_load_;
    } else {
        find_near(state, near_);
    }
    near_known_ = true;
    return near_;
}

void ExpandedDisplacement::find_near(const GammaState& state, Eigen::VectorXd& u) const {
    structure_.expand_near(state.displacement, state.factors(), 1.0, u);
    ++work_.structure_solves_near;
}

DisplacementBesideFar ExpandedDisplacement::beside_far(const GammaState& state) const {
    Eigen::VectorXd u = near(state);
    auto far = structure_.beside_near(state.factors(), 1.0, u);
    return {std::move(u), std::move(far)};
}

}  // namespace stria::coarse
