// A linear elastic structure as a leaf of the tree of substructures: condensed once by a supernodal Cholesky factor
// with the boundary ordered last; S is its trailing block (docs/method.md, section 10).
#pragma once

#include <memory>
#include <vector>

#include "common/linear/sparse.hpp"
#include "common/substructure/substructure.hpp"

namespace stria {

class SparseLeaf : public Substructure {
public:
    /// `stiffness`: symmetric, its lower triangle is read, unknowns 0..n-1. `boundary`: the unknowns to keep, may be
    /// empty. A body that floats on its boundary is allowed (S is then singular, exactly). Throws NumericalFailure
    /// where K_ii is not positive definite.
    SparseLeaf(const SparseMatrix& stiffness, const std::vector<int>& boundary);

    /// Of a lower triangle whose unknowns are numbered in a good order of elimination, the last `boundary` ones to
    /// keep: for large structures (nested_dissection.hpp). Spoils `lower`.
    SparseLeaf(int boundary, SparseMatrix&& lower);
    ~SparseLeaf() override;

    [[nodiscard]] const Eigen::MatrixXd& tangent() const override;
    [[nodiscard]] ReducedLoad reduce(const Eigen::VectorXd& load) const override;
    [[nodiscard]] Eigen::VectorXd expand(const ReducedLoad& load, const Eigen::VectorXd& boundary) const override;

    /// The last unknowns of expand() in the order of elimination, the boundary after them: reads their columns of the
    /// factor and no others. `last_of_load`: the end of ReducedLoad::interior, as long as there are unknowns wanted.
    [[nodiscard]] Eigen::VectorXd expand_last(const Eigen::VectorXd& last_of_load,
                                              const Eigen::VectorXd& boundary) const;

    /// The boundary's included.
    [[nodiscard]] int unknowns() const;

    /// Entries in the Cholesky factor.
    [[nodiscard]] double factor_entries() const;

private:
    void condense(SparseMatrix& lower);

    struct Factor;  // CHOLMOD stays behind this door
    std::unique_ptr<Factor> factor_;
    Eigen::MatrixXd tangent_;
};

}  // namespace stria
