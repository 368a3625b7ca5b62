#include "common/substructure/stacked_leaf.hpp"

#include <utility>

#include "common/error.hpp"

namespace stria {

StackedLeaf::StackedLeaf(std::shared_ptr<const Substructure> below, std::vector<int> rim,
                         std::shared_ptr<const SparseLeaf> above)
    : below_(std::move(below)), rim_(std::move(rim)), above_(std::move(above)) {
    require(!below_ || below_->tangent().rows() == std::ssize(rim_), "stacked leaf: the rim is the boundary below");
}

ReducedLoad StackedLeaf::reduce(const Eigen::VectorXd& load) const {
    if (!below_) return above_->reduce(load);
    const Eigen::Index above = above_->unknowns();
    ReducedLoad all{Eigen::VectorXd(load.size() - tangent().rows()), {}};
    all.boundary = reduce(load.head(load.size() - above), load.tail(above), all.interior);
    return all;
}

Eigen::VectorXd StackedLeaf::reduce_interior(const ConstPart& load, Part reduced) const {
    if (!below_) return above_->reduce_interior(load, reduced);
    Eigen::VectorXd above = Eigen::VectorXd::Zero(above_->unknowns());
    const Eigen::Index loaded = above.size() - tangent().rows();
    above.head(loaded) = load.tail(loaded);
    return reduce(load.head(load.size() - loaded), std::move(above), reduced);
}

// The load below may be long: it is passed on as it stands.
Eigen::VectorXd StackedLeaf::reduce(const ConstPart& below, Eigen::VectorXd above, Part reduced) const {
    above(rim_) += below_->reduce_interior(below, reduced.head(below.size()));
    ReducedLoad upper = above_->reduce(above);
    reduced.tail(upper.interior.size()) = upper.interior;
    return std::move(upper.boundary);
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
