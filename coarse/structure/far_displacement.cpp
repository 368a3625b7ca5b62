#include "coarse/structure/far_displacement.hpp"

#include <algorithm>

namespace stria::coarse {

bool FarDisplacement::is_of_some(const ElementSet& elements) const { return contains_any(*far_, elements.members()); }

void FarDisplacement::put(const std::vector<int>& unknowns, Eigen::VectorXd& u) const {
    const Eigen::VectorXd inside = far_->expand({load_, {}}, rim_);
    for (std::size_t k = 0; k < unknowns.size(); ++k) u[unknowns[k]] = inside[static_cast<Eigen::Index>(k)];
}

}  // namespace stria::coarse
