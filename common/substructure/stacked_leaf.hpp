// A structure condensed in two steps: a part below, onto the rim that it shares with the rest, and the rest with that
// on top. The part below may serve several structures.
#pragma once

#include <memory>
#include <vector>

#include "common/substructure/sparse_leaf.hpp"

namespace stria {

/// Unknowns: the interior of the part below, then those above, the boundary last.
class StackedLeaf : public Substructure {
public:
    /// `below`: may be null; its boundary is the rim. `rim`: place of each unknown of it above. `above`: of a matrix
    /// that has below's tangent on the rim. Both numbered in their orders of elimination.
    StackedLeaf(std::shared_ptr<const Substructure> below, std::vector<int> rim,
                std::shared_ptr<const SparseLeaf> above);

    [[nodiscard]] const Eigen::MatrixXd& tangent() const override { return above_->tangent(); }
    [[nodiscard]] ReducedLoad reduce(const Eigen::VectorXd& load) const override;
    [[nodiscard]] Eigen::VectorXd reduce_interior(const ConstPart& load, Part reduced) const override;
    [[nodiscard]] Eigen::VectorXd expand(const ReducedLoad& load, const Eigen::VectorXd& boundary) const override;

    /// What of expand() lies above, which asks for no column of the factor below. `load_above`: the end of
    /// ReducedLoad::interior that belongs to it.
    [[nodiscard]] Eigen::VectorXd expand_above(const Eigen::VectorXd& load_above,
                                               const Eigen::VectorXd& boundary) const;
    /// Of that, what lies on the rim.
    [[nodiscard]] Eigen::VectorXd on_rim(const Eigen::VectorXd& above) const { return above(rim_); }

private:
    /// `below`, `above`: loads, in place; what the interior of both makes of them into `reduced`.
    [[nodiscard]] Eigen::VectorXd reduce(const ConstPart& below, Eigen::VectorXd above, Part reduced) const;

    std::shared_ptr<const Substructure> below_;
    std::vector<int> rim_;
    std::shared_ptr<const SparseLeaf> above_;
};

}  // namespace stria
