#include "common/substructure/stacked_leaf.hpp"

#include "common/error.hpp"

namespace stria {

StackedLeaf::StackedLeaf(std::shared_ptr<const Substructure> below, std::vector<int> rim,
                         std::shared_ptr<const SparseLeaf> above)
    : below_(std::move(below)), rim_(std::move(rim)), above_(std::move(above)) {
    require(!below_ || below_->tangent().rows() == std::ssize(rim_), "stacked leaf: the rim is the boundary below");
}

ReducedLoad StackedLeaf::reduce(const Eigen::VectorXd& load) const {
    if (!below_) return above_->reduce(load);
    const Eigen::Index inner = load.size() - above_->unknowns();
    Eigen::VectorXd own = Eigen::VectorXd::Zero(inner + std::ssize(rim_));
    own.head(inner) = load.head(inner);
    const ReducedLoad lower = below_->reduce(own);
    Eigen::VectorXd rest = load.tail(above_->unknowns());
    rest(rim_) += lower.boundary;
    const ReducedLoad upper = above_->reduce(rest);
    Eigen::VectorXd interior(inner + upper.interior.size());
    interior << lower.interior, upper.interior;
    return {std::move(interior), upper.boundary};
}

Eigen::VectorXd StackedLeaf::expand(const ReducedLoad& load, const Eigen::VectorXd& boundary) const {
    if (!below_) return above_->expand(load, boundary);
    const Eigen::Index interior_above = above_->unknowns() - boundary.size();
    const Eigen::Index inner = load.interior.size() - interior_above;
    const Eigen::VectorXd above = above_->expand({load.interior.tail(interior_above), load.boundary}, boundary);
    const Eigen::VectorXd below = below_->expand({load.interior.head(inner), {}}, above(rim_));
    Eigen::VectorXd x(inner + above.size());
    x << below.head(inner), above;
    return x;
}

Eigen::VectorXd StackedLeaf::expand_above(const Eigen::VectorXd& load_above, const Eigen::VectorXd& boundary) const {
    return above_->expand_last(load_above, boundary);
}

}  // namespace stria
